// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a point lies on the part of a shape that was seen.
#pragma once

#include <algorithm>
#include <limits>

#include "core/frame_memory.h"
#include "kernels/loops.h"
#include "primitect/primitives.h"

namespace primitect {

/// What lies on the inner side of some planes: those across a plane's outline, or across the two ends of an axis; all
/// of a sphere. In float: for points within a few hundred metres of the origin.
class ObservedPart {
 public:
  ObservedPart(const Shape& shape, const Extent& extent);

  /// How far (m) a point near the surface lies within the part, negative: outside of it by at least so much. It changes
  /// by no more than the point moves.
  float depth(float x, float y, float z) const {
    float least = std::numeric_limits<float>::infinity();
    for (const kernels::FlatSide& side : sides_)
      least = std::min(least, side.x * x + side.y * y + side.z * z - side.offset);
    return least;
  }

  /// A point near the surface lies within the part enlarged by margin (m, not negative).
  bool holds(float x, float y, float z, float margin) const {
    // Most points of a large plane lie within the ball that touches the nearest side.
    const float dx = x - center_[0], dy = y - center_[1], dz = z - center_[2];
    if (dx * dx + dy * dy + dz * dz < ball_sq_) return true;
    for (const kernels::FlatSide& side : sides_) {
      if (side.x * x + side.y * y + side.z * z - side.offset < -margin) return false;
    }
    return true;
  }

  /// Appends the sides from which a ball within the surface's reach does not keep clear (m).
  void addSidesNear(float x, float y, float z, float radius, List<kernels::FlatSide>& sides) const;

  kernels::FlatPart view() const { return {sides_.data(), sides_.size()}; }

 private:
  void addSide(const Vec3& inward, const Vec3& point);

  List<kernels::FlatSide> sides_;
  float center_[3];
  float ball_sq_;  ///< m^2, squared radius around the centre; negative: there is no such ball
};

}  // namespace primitect
