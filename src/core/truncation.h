// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Why the seen part of a shape ends where it ends: on its own, or because the sensor could see no more of it.
#pragma once

#include <cstdint>
#include <utility>

#include "core/frame_memory.h"
#include "core/image_rays.h"
#include "core/point_noise.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// What the sensor could not see of a shape.
struct Truncated {
  std::uint8_t by = kTruncationUnknown;     ///< bits of Truncation
  std::uint8_t unseen_ends = kEndsUnknown;  ///< see Extent
};

/// Of one frame. The cloud must outlive it.
class TruncationFinder {
 public:
  /// range: outside of it, points of this cloud were made missing. sigma(p): m, noise of the distance to a surface.
  TruncationFinder(const Cloud& cloud, const ImageRays& rays, const DepthRange& range, PointNoise sigma);
  TruncationFinder(const Cloud& cloud, const DepthRange& range, PointNoise sigma)
      : TruncationFinder(cloud, findRays(cloud), range, std::move(sigma)) {}

  /// Of a shape with these points of the cloud. From the outermost of them the image is followed
  /// along the surface to the first pixel that is not on it, in rows and columns; a tenth of these walks decides, or
  /// where half of those at an end of the axis, or of a plane's longer side, are cut off, every reason of one of these:
  ///   image      it is outside of what the sensor measures
  ///   depth      the surface there is out of range
  ///   occlusion  something clearly nearer hides the surface. What touches it (the table below a can) does not count,
  ///              nor does what lies beyond the limb, where a ray no longer meets the surface. A hollow may hide
  ///              itself: the near wall of a cup hides the lower part of its inside.
  /// A cloud that is not a pinhole image tells the depth only: the bit is set when the farthest or nearest points reach
  /// the bound, along with kTruncationUnknown.
  Truncated find(const Shape& shape, const Extent& extent, const List<std::uint32_t>& inlier_points) const;

 private:
  const Cloud& cloud_;
  ImageRays rays_;
  DepthRange range_;
  PointNoise sigma_;
};

}  // namespace primitect
