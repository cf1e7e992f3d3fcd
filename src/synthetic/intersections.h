// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a ray meets a solid, in closed form, in the solid's own frame.
#pragma once

#include <cmath>

#include "synthetic/world.h"

namespace primitect::synthetic {

/// The first point of a ray origin + t * direction on a solid; t <= 0 or NaN: it misses.
struct Hit {
  double t = 0.0;
  int face = 0;  ///< which surface of the body, as ordered in world.h
};

/// The origin is outside of the solid in all of these.
inline Hit intersect(const Sheet& sheet, const Vec3& origin, const Vec3& direction) {
  const double t = -origin.z() / direction.z();
  const bool inside = std::abs(origin.x() + t * direction.x()) <= sheet.half_x &&
                      std::abs(origin.y() + t * direction.y()) <= sheet.half_y;
  return inside ? Hit{t, 0} : Hit{};
}

/// Slab method: the ray is inside of the box where it is between all three pairs of sides.
inline Hit intersect(const Box& box, const Vec3& origin, const Vec3& direction) {
  const double half[3] = {box.half_x, box.half_y, box.half_z};
  Hit hit{-1e300, 0};
  double leave = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / direction[axis];
    const double side = inverse < 0.0 ? 1.0 : -1.0;
    const double enter = (side * half[axis] - origin[axis]) * inverse;
    const double exit = (-side * half[axis] - origin[axis]) * inverse;
    // A ray within a side's plane gives NaN: neither comparison holds and the other axes decide.
    if (enter > hit.t) hit = {enter, 2 * axis + (side > 0.0 ? 1 : 0)};
    if (exit < leave) leave = exit;
  }
  return hit.t <= leave ? hit : Hit{};
}

inline Hit intersect(const Ball& ball, const Vec3& origin, const Vec3& direction) {
  const double a = direction.squaredNorm();
  const double half_b = origin.dot(direction);
  const double c = origin.squaredNorm() - ball.radius * ball.radius;
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0.0) return {};
  return {(-half_b - std::sqrt(discriminant)) / a, 0};
}

/// A disc of the given radius at z = height: the distance along the ray, or 0 when it misses.
inline double intersectDisc(double height, double radius, const Vec3& origin, const Vec3& direction) {
  const double t = (height - origin.z()) / direction.z();
  const double x = origin.x() + t * direction.x();
  const double y = origin.y() + t * direction.y();
  return x * x + y * y <= radius * radius ? t : 0.0;
}

inline Hit intersect(const Rod& rod, const Vec3& origin, const Vec3& direction) {
  const double a = direction.head<2>().squaredNorm();
  const double half_b = origin.head<2>().dot(direction.head<2>());
  const double c = origin.head<2>().squaredNorm() - rod.radius * rod.radius;
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0.0) return {};
  const double t = (-half_b - std::sqrt(discriminant)) / a;
  if (t > 0.0 && std::abs(origin.z() + t * direction.z()) <= rod.half_length) return {t, 0};
  // From outside, a ray that does not enter by the mantle can only enter by the cap that faces it.
  if (origin.z() > rod.half_length) return {intersectDisc(rod.half_length, rod.radius, origin, direction), 2};
  if (origin.z() < -rod.half_length) return {intersectDisc(-rod.half_length, rod.radius, origin, direction), 1};
  return {};
}

inline Hit intersect(const Frustum& frustum, const Vec3& origin, const Vec3& direction) {
  const double slope = std::tan(frustum.half_angle);
  const double slope_sq = slope * slope;
  Hit nearest{1e300, 0};
  const auto take = [&nearest](double t, int face) {
    if (t > 0.0 && t < nearest.t) nearest = {t, face};
  };
  const double a = direction.head<2>().squaredNorm() - slope_sq * direction.z() * direction.z();
  const double half_b = origin.head<2>().dot(direction.head<2>()) - slope_sq * origin.z() * direction.z();
  const double c = origin.head<2>().squaredNorm() - slope_sq * origin.z() * origin.z();
  const double discriminant = half_b * half_b - a * c;
  if (discriminant >= 0.0) {
    // Both roots without cancellation; a ray along the mantle gives infinity or NaN for one, which is then left out.
    const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    for (const double t : {q / a, c / q}) {
      const double height = origin.z() + t * direction.z();
      if (height >= frustum.begin && height <= frustum.end) take(t, 0);
    }
  }
  take(intersectDisc(frustum.end, frustum.end * slope, origin, direction), 1);
  if (frustum.begin > 0.0) take(intersectDisc(frustum.begin, frustum.begin * slope, origin, direction), 2);
  return nearest.t < 1e300 ? nearest : Hit{};
}

}  // namespace primitect::synthetic
