// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Boxes around runs of samples: neighbours in space are neighbours in memory, so most runs are too far for a reference.
#pragma once

#include "core/frame_memory.h"
#include "core/samples.h"

namespace primitect {

class SampleBoxes {
 public:
  /// Measures the boxes of these samples; samples that lack a number have no part in them.
  void enclose(const Samples& samples);

  /// What the kernels read; valid until the next enclose() and as long as this object is not moved.
  kernels::Boxes view() const;

 private:
  List<float> min_x_, min_y_, min_z_, max_x_, max_y_, max_z_;
  std::size_t count_ = 0;
};

}  // namespace primitect
