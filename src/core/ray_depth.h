// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The depth at which the ray of a pixel meets a shape.
#pragma once

#include <cmath>
#include <optional>

#include "primitect/primitives.h"

namespace primitect {

/// Distance of a point on a ray, and its growth along the ray.
struct Approach {
  double away, slope;
};

inline Approach approach(const Plane& plane, const Vec3& p, const Vec3& ray) {
  return {plane.normal.dot(p - plane.point), plane.normal.dot(ray)};
}

inline Approach approach(const Sphere& sphere, const Vec3& p, const Vec3& ray) {
  const Vec3 out = p - sphere.center;
  const double away = out.norm();
  return {away - sphere.radius, out.dot(ray) / away};
}

inline Approach approach(const Cylinder& cylinder, const Vec3& p, const Vec3& ray) {
  const Vec3 offset = p - cylinder.point, out = offset - offset.dot(cylinder.axis) * cylinder.axis;
  const double away = out.norm();
  return {away - cylinder.radius, out.dot(ray) / away};
}

/// A cone whose sine and cosine are worked out once.
struct OpenCone {
  Cone cone;
  double sine, cosine;
};

inline Approach approach(const OpenCone& open, const Vec3& p, const Vec3& ray) {
  const Vec3 offset = p - open.cone.apex;
  const double height = offset.dot(open.cone.axis);
  const Vec3 out = offset - height * open.cone.axis;
  const double away = out.norm();
  if (height * open.cosine + away * open.sine < 0.0) return {offset.norm(), offset.dot(ray) / offset.norm()};
  return {away * open.cosine - height * open.sine,
          open.cosine * out.dot(ray) / away - open.sine * open.cone.axis.dot(ray)};
}

template <class T>
const T& opened(const T& shape) {
  return shape;
}
inline OpenCone opened(const Cone& cone) { return {cone, std::sin(cone.half_angle), std::cos(cone.half_angle)}; }

constexpr double kGrazing = 0.05;  // sine of 3 deg

/// Depth at which the ray meets the shape, by Newton's method from a depth nearby: of two crossings it finds that on
/// whose side the walk is, so that shapes seen from inside need no care. Nothing at the limb.
template <class T>
std::optional<double> depthOn(const T& shape, const Vec3& ray, double depth) {
  constexpr double kExact = 1e-4;  // m
  const double least_slope_sq = kGrazing * kGrazing * ray.squaredNorm();
  for (int iteration = 0; iteration < 8; ++iteration) {
    const Approach here = approach(shape, depth * ray, ray);
    if (std::abs(here.away) < kExact) return depth;
    // Not of numbers where there is no normal.
    if (!(here.slope * here.slope > least_slope_sq)) return std::nullopt;
    depth -= here.away / here.slope;
    if (!(depth > 0.0)) return std::nullopt;
  }
  return std::nullopt;
}
/// A plane without a search.
inline std::optional<double> depthOn(const Plane& plane, const Vec3& ray, double) {
  const double slope = plane.normal.dot(ray);
  if (!(slope * slope > kGrazing * kGrazing * ray.squaredNorm())) return std::nullopt;
  const double depth = plane.normal.dot(plane.point) / slope;
  return depth > 0.0 ? std::optional<double>(depth) : std::nullopt;
}

}  // namespace primitect
