// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a ray meets the solids that are none of the four kinds; all but ellipsoids by sphere tracing.
#pragma once

#include <algorithm>
#include <cmath>

#include "synthetic/intersections.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

/// Scaled to a unit sphere, which keeps t.
inline Hit intersect(const Ellipsoid& ellipsoid, const Vec3& origin, const Vec3& direction) {
  const Vec3 half(ellipsoid.half_x, ellipsoid.half_y, ellipsoid.half_z);
  return intersect(Ball{1.0}, Vec3(origin.cwiseQuotient(half)), Vec3(direction.cwiseQuotient(half)));
}

/// Sphere tracing (Hart 1996): `distance` is never more than that to the surface, which lies within the ball of the
/// given radius around the origin. The hit is within 1e-7 m of the surface; a ray that grazes it at less than about
/// 1e-6 m may count as either.
template <class Distance>
Hit trace(const Distance& distance, double radius, const Vec3& origin, const Vec3& direction) {
  constexpr double kNear = 1e-7;  // m
  constexpr int kMaxSteps = 500;
  const double length = direction.norm();
  const double closest = -origin.dot(direction) / length;
  const double half_chord_sq = radius * radius - (origin.squaredNorm() - closest * closest);
  if (half_chord_sq < 0.0) return {};
  const double leave = (closest + std::sqrt(half_chord_sq)) / length;
  double t = std::max(0.0, (closest - std::sqrt(half_chord_sq)) / length);
  for (int step = 0; step < kMaxSteps && t <= leave; ++step) {
    const double free = distance(Vec3(origin + t * direction));
    if (free < kNear) return {t, 0};
    t += free / length;
  }
  return {};
}

inline Hit intersect(const Torus& torus, const Vec3& origin, const Vec3& direction) {
  const auto distance = [&torus](const Vec3& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - torus.ring_radius, p.z()) - torus.tube_radius;
  };
  return trace(distance, torus.ring_radius + torus.tube_radius, origin, direction);
}

inline Hit intersect(const Lump& lump, const Vec3& origin, const Vec3& direction) {
  // The waves change by at most frequency / sqrt(3) per unit of direction, a direction by 1 / |p| per metre, and
  // |p| is at least radius (1 - bump) outside: that bounds the gradient of |p| - reach.
  const double steepest = lump.bump * lump.frequency / (std::sqrt(3.0) * (1.0 - lump.bump));
  const double shrink = 1.0 / std::sqrt(1.0 + steepest * steepest);
  const auto distance = [&lump, shrink](const Vec3& p) {
    const double length = p.norm();
    return (length - lump.reach(p / length)) * shrink;
  };
  return trace(distance, lump.radius * (1.0 + lump.bump), origin, direction);
}

inline Hit intersect(const Cloth& cloth, const Vec3& origin, const Vec3& direction) {
  const double reach = Vec3(cloth.half_x, cloth.half_y, cloth.highest()).norm();
  return trace([&cloth](const Vec3& p) { return cloth.distanceTo(p); }, reach, origin, direction);
}

inline Hit intersect(const Leaf& leaf, const Vec3& origin, const Vec3& direction) {
  const double reach = std::hypot(std::max(leaf.half_x, leaf.half_y), leaf.highest());
  return trace([&leaf](const Vec3& p) { return leaf.distanceTo(p); }, reach, origin, direction);
}

inline Hit intersect(const Limbs& limbs, const Vec3& origin, const Vec3& direction) {
  return trace([&limbs](const Vec3& p) { return limbs.distanceTo(p); }, limbs.reach, origin, direction);
}

}  // namespace primitect::synthetic
