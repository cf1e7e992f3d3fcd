// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// An order of points in which neighbours in space are near each other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/loops.h"

namespace primitect {

/// Sorts points along the Hilbert curve; its buffers are kept. Unlike the Z curve it never jumps: boxes around runs of
/// samples, eight or 64 to a run, are smaller.
class SpaceCurve {
 public:
  /// The order of these points: positions in the lists, along the curve; as they come within a cell. The cube around
  /// most of them is divided into cells; the few farther out fall into the outermost.
  const std::vector<std::uint32_t>& order(const std::vector<float>& x, const std::vector<float>& y,
                                          const std::vector<float>& z);

 private:
  struct Entry {
    std::uint32_t place, position;
  };

  kernels::CellCube cubeAround(const std::array<const std::vector<float>*, 3>& fields);
  void sortByPlace();

  std::vector<Entry> entries_, sorted_;
  std::vector<float> some_;
  std::vector<std::uint32_t> place_, order_;
};

}  // namespace primitect
