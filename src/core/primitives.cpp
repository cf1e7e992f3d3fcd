// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Distances, normals and projections of the four shapes.
#include "primitect/primitives.h"

#include <Eigen/Geometry>
#include <cmath>

namespace primitect {
namespace {

/// v / |v|, or the fallback where v has no direction.
Vec3 directionOr(const Vec3& v, const Vec3& fallback) {
  const double length = v.norm();
  return length > 1e-12 ? Vec3(v / length) : fallback;
}

/// From the axis straight out to p; on the axis some direction across it.
Vec3 radialDirection(const Vec3& axis, const Vec3& from_axis_point) {
  const Vec3 across = from_axis_point - from_axis_point.dot(axis) * axis;
  return directionOr(across, axis.unitOrthogonal());
}

/// A cone in the half plane (height along the axis, distance from it): where p is, seen from the apex.
struct ConeView {
  Vec3 radial;
  double height;
  double radius;
  bool apex_is_nearest;  ///< p lies behind the apex, where no point of the slant is nearest
};

ConeView viewOf(const Cone& cone, const Vec3& p) {
  const Vec3 from_apex = p - cone.apex;
  const Vec3 radial = radialDirection(cone.axis, from_apex);
  const double height = from_apex.dot(cone.axis);
  const double radius = from_apex.dot(radial);
  const bool behind = height * std::cos(cone.half_angle) + radius * std::sin(cone.half_angle) < 0.0;
  return {radial, height, radius, behind};
}

}  // namespace

const char* kindName(Kind kind) {
  constexpr const char* kNames[] = {"plane", "sphere", "cylinder", "cone"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* statusName(Status status) {
  constexpr const char* kNames[] = {"ok", "empty_input", "too_few_points", "rejected_input", "no_transform"};
  return kNames[static_cast<std::size_t>(status)];
}

const char* refusalName(Refusal refusal) {
  constexpr const char* kNames[] = {"few inliers", "too large", "too small", "half angle",
                                    "edge-on",     "unlikely",  "not seen"};
  return kNames[static_cast<std::size_t>(refusal)];
}

double distance(const Plane& plane, const Vec3& p) { return plane.normal.dot(p - plane.point); }

double distance(const Sphere& sphere, const Vec3& p) { return (p - sphere.center).norm() - sphere.radius; }

double distance(const Cylinder& cylinder, const Vec3& p) {
  return (p - cylinder.point).cross(cylinder.axis).norm() - cylinder.radius;
}

double distance(const Cone& cone, const Vec3& p) {
  const ConeView view = viewOf(cone, p);
  if (view.apex_is_nearest) return (p - cone.apex).norm();
  return view.radius * std::cos(cone.half_angle) - view.height * std::sin(cone.half_angle);
}

double distance(const Shape& shape, const Vec3& p) {
  return std::visit([&p](const auto& s) { return distance(s, p); }, shape);
}

Vec3 normalAt(const Plane& plane, const Vec3&) { return plane.normal; }

Vec3 normalAt(const Sphere& sphere, const Vec3& p) { return directionOr(p - sphere.center, Vec3::UnitZ()); }

Vec3 normalAt(const Cylinder& cylinder, const Vec3& p) { return radialDirection(cylinder.axis, p - cylinder.point); }

Vec3 normalAt(const Cone& cone, const Vec3& p) {
  const ConeView view = viewOf(cone, p);
  if (view.apex_is_nearest) return directionOr(p - cone.apex, -cone.axis);
  return std::cos(cone.half_angle) * view.radial - std::sin(cone.half_angle) * cone.axis;
}

Vec3 normalAt(const Shape& shape, const Vec3& p) {
  return std::visit([&p](const auto& s) { return normalAt(s, p); }, shape);
}

Vec3 project(const Shape& shape, const Vec3& p) { return p - distance(shape, p) * normalAt(shape, p); }

}  // namespace primitect
