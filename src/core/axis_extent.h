// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The part of a cylinder or a cone that was seen.
#pragma once

#include <optional>

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Cylinders and cones: the extent has a length along z, and two ends.
inline bool hasAxis(Kind kind) { return kind == Kind::cylinder || kind == Kind::cone; }

/// Direction of the axis of a cylinder or a cone; nothing of other kinds.
inline std::optional<Vec3> axisOf(const Shape& shape) {
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->axis;
  if (const Cone* cone = std::get_if<Cone>(&shape)) return cone->axis;
  return std::nullopt;
}

/// How far the ends of an axis go: without_stragglers leaves the outer 1 % of the points at either end out. to_the_end
/// goes on from there by as much surface as the next 1 % cover, but not beyond the outermost point; stragglers stretch
/// it by no more than that. A cone's narrow end that may be its tip, as far as the number of points tells, lies at the
/// outermost that is no straggler.
enum class Ends { without_stragglers, to_the_end };

/// Of at least one inlier (m).
Extent extentAlong(const Cylinder& cylinder, const SeenPoints& inliers, Ends ends);
Extent extentAlong(const Cone& cone, const SeenPoints& inliers, Ends ends);

/// Moves the ends by so much (m) along the axis, and a cone's radii with them; by 0 a radius stays as it is, to the
/// last bit.
void moveEnds(double low, double high, const Shape& shape, Extent& extent);

/// A length of an axis (m, from the extent's origin).
struct AxisPart {
  float low, high;

  bool holds(float height) const { return height >= low && height <= high; }
};

/// The extent of that part of what this one is the extent of.
void keepTo(const AxisPart& part, const Shape& shape, Extent& extent);

}  // namespace primitect
