// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Errors of the depth that change slowly over an image, as a camera's calibration leaves them.
#pragma once

#include <array>
#include <cstddef>

#include "core/frame_memory.h"
#include "core/seen_points.h"

namespace primitect {

/// A field of random errors over the directions of sight, the same everywhere.
struct DepthWaves {
  double share = 0.0;  ///< of the depth, one standard deviation; 0: none are known
  double reach = 1.0;  ///< of x / z and y / z: errors this far from each other are half as much alike as neighbours'

  /// Correlation of errors whose distance in these coordinates has this square. A mixture of Gaussians of many widths:
  /// covariances made of it are ones.
  double alike(double apart_sq) const { return 1.0 / (1.0 + apart_sq / (reach * reach)); }
};

/// Finds them where they show: on large planes. How much a row of three cells of the image bends, in the mean of the
/// relative errors of their depths, does not depend on where the plane is said to be, so that nothing of long waves is
/// lost in its fit; and it grows with the distance of the cells as waves become less alike.
class WaveFinder {
 public:
  /// Points that belong to one plane, in the frame of the depth camera that saw them. What has too few of them, or
  /// covers too little of the image, tells nothing.
  void see(const SeenPoints& plane);

  /// From all planes that were seen; none where chance may have made it.
  DepthWaves waves() const;

 private:
  /// Of cells at one distance, each with the weight that its noise leaves it.
  struct Bends {
    double sum = 0.0;     ///< of weighted squares, without what the noise of the points makes of them
    double weight = 0.0;  ///< of the weights
    double chance = 0.0;  ///< variance of `sum` where there is only that noise
  };

  /// Waves of some reach.
  struct Fit {
    double share_sq = 0.0;
    double deviation = 0.0;  ///< of it, by chance
    double misfit = 0.0;
  };

  static constexpr std::size_t kDistances = 7;

  Fit fitted(double reach) const;

  std::array<Bends, kDistances> seen_ = {};
};

}  // namespace primitect
