// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Feet of the middle, and what touches there; see seen_side.h.
#include "core/seen_side.h"

#include <cmath>

namespace primitect {

SeenSide seenSide(const Cylinder& cylinder, const Vec3& middle) {
  const Vec3 outward = normalAt(cylinder, middle);
  return {middle - distance(cylinder, middle) * outward, outward, cylinder.radius};
}

std::optional<SeenSide> seenSide(const Cone& cone, const Vec3& middle) {
  constexpr double kLeast = 1e-6;  // m
  const Vec3 outward = normalAt(cone, middle), point = middle - distance(cone, middle) * outward;
  const double slant = (point - cone.apex).norm();
  if (!(slant > kLeast)) return std::nullopt;
  return SeenSide{point, outward, slant * std::tan(cone.half_angle)};
}

Cone coneAlong(const Vec3& line, const SeenSide& side, double half_angle) {
  return {side.point - side.radius / std::tan(half_angle) * line,
          std::cos(half_angle) * line - std::sin(half_angle) * side.outward, half_angle};
}

}  // namespace primitect
