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

}  // namespace primitect
