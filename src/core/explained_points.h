// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which of some points belong to shapes that were found already.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/observed_part.h"
#include "core/tolerance.h"
#include "kernels/loops.h"
#include "primitect/primitives.h"

namespace primitect {

/// Points that lie within the tolerance of one of the detections' surfaces, and within its observed part enlarged by
/// it: those that labelPoints would give a label.
class ExplainedPoints {
 public:
  static constexpr std::size_t kAtOnce = 64;

  /// Nothing is explained.
  ExplainedPoints() = default;
  ExplainedPoints(const std::vector<Detection>& detections, const Tolerance& tolerance);

  bool none() const { return targets_.empty(); }

  /// Sets explained[i] to 1 or 0 for each of at most kAtOnce points.
  void find(const float* x, const float* y, const float* z, std::size_t count, std::uint8_t* explained) const;

 private:
  struct Target {
    kernels::FlatShape shape;
    ObservedPart part;
  };

  std::vector<Target> targets_;
  Tolerance tolerance_;
};

}  // namespace primitect
