// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where tubes, cones and balls that may stand for the same points touch each other.
#pragma once

#include <optional>

#include "primitect/primitives.h"

namespace primitect {

/// A point of a surface (m) in the middle of its seen side, and how the surface is curved there across the axis.
struct SeenSide {
  Vec3 point, outward;
  double radius;  ///< m
};

/// middle: of the points that were seen (m).
SeenSide seenSide(const Cylinder& cylinder, const Vec3& middle);
/// Nothing for points at the apex.
std::optional<SeenSide> seenSide(const Cone& cone, const Vec3& middle);

/// The cone that touches a surface along a line in the middle of its seen side, and is as round there. line: its
/// direction, of length 1, away from the apex.
Cone coneAlong(const Vec3& line, const SeenSide& side, double half_angle);

}  // namespace primitect
