// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The hemisphere accumulator ball: its rings, the direction of each bin, and each bin's neighbours.
#pragma once

#include <vector>

#include "core/frame_memory.h"
#include "kernels/kernels.h"
#include "primitect/primitives.h"

namespace primitect {

/// Bins for axes without sign (Borrmann et al. 2011, here a hemisphere); 206 bins at 10 deg.
class AxisBall {
 public:
  /// Bins of about this width (rad).
  explicit AxisBall(double bin_width);

  int binCount() const { return static_cast<int>(directions_.size()); }

  /// Unit direction of the bin's centre, z >= 0.
  const Vec3& direction(int bin) const { return directions_[bin]; }

  /// The bins that touch this one, itself first.
  const List<int>& neighborhood(int bin) const { return neighborhoods_[bin]; }

  /// What the kernels read; valid as long as this object lives and is not moved.
  kernels::AxisBall view() const { return {rings_, static_cast<float>(step_), ring_start_.data(), ring_size_.data()}; }

 private:
  void addRing(int ring);
  void findNeighborhoods();

  int rings_;
  double step_;
  List<int> ring_start_, ring_size_;
  std::vector<Vec3> directions_;
  List<List<int>> neighborhoods_;
};

}  // namespace primitect
