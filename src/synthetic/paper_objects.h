// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The random objects of the paper's data set, each with the surface that is seen from above.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/random.h"
#include "primitect/primitives.h"

namespace primitect::synthetic {

constexpr double kHalfWidth = 2.0;  // m, the field is [-2, 2] in x and y
constexpr double kCeiling = 2.0;    // m, cylinders and cones end there
constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// A shape and its upper surface: the height at (x, y), or kNothing.
struct PaperObject {
  Shape shape;
  std::function<double(double, double)> height;
};

/// Uniform over the field in x and y and over the given z.
inline Vec3 drawPoint(Random& random, double z_min, double z_max) {
  const double x = random.uniform(-kHalfWidth, kHalfWidth);
  const double y = random.uniform(-kHalfWidth, kHalfWidth);
  return {x, y, random.uniform(z_min, z_max)};
}

/// A normalised Gaussian vector whose z component is stretched first.
inline Vec3 drawDirection(Random& random, double z_stretch) {
  const double x = random.gaussian();
  const double y = random.gaussian();
  return Vec3(x, y, z_stretch * random.gaussian()).normalized();
}

/// The larger root of a t^2 + 2 b t + c, a > 0, or kNothing.
inline double upperRoot(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  return discriminant < 0.0 ? kNothing : (-b + std::sqrt(discriminant)) / a;
}

/// The plane z = 0.1 x behind everything.
inline PaperObject background() {
  return {Plane{Vec3::Zero(), Vec3(-0.1, 0.0, 1.0).normalized()}, [](double x, double) { return 0.1 * x; }};
}

inline PaperObject objectOf(const Sphere& sphere) {
  return {sphere, [sphere](double x, double y) {
            const double dx = x - sphere.center.x(), dy = y - sphere.center.y();
            return sphere.center.z() + upperRoot(1.0, 0.0, dx * dx + dy * dy - sphere.radius * sphere.radius);
          }};
}

/// Centre in [-2, 2] x [-2, 2] x [-1, 1], radius in [0.05, 1], not wholly below z = 0.
inline PaperObject drawSphere(Random& random) {
  Sphere sphere;
  do {
    sphere.center = drawPoint(random, -1.0, 1.0);
    sphere.radius = random.uniform(0.05, 1.0);
  } while (sphere.center.z() + sphere.radius < 0.0);
  return objectOf(sphere);
}

/// Its axis is not upright.
inline double cylinderHeight(const Cylinder& cylinder, double x, double y) {
  // |p|^2 - (p.a)^2 = R^2 along p = (dx, dy, t).
  const double dx = x - cylinder.point.x(), dy = y - cylinder.point.y();
  const double along = dx * cylinder.axis.x() + dy * cylinder.axis.y(), axis_z = cylinder.axis.z();
  const double rest = dx * dx + dy * dy - along * along - cylinder.radius * cylinder.radius;
  const double z = cylinder.point.z() + upperRoot(1.0 - axis_z * axis_z, -along * axis_z, rest);
  return z < kCeiling ? z : kNothing;
}

/// Axis point in [-2, 2] x [-2, 2] x [-1, 1], |axis_z| <= 0.8, radius in [0.05, 1].
inline PaperObject drawCylinder(Random& random) {
  Cylinder cylinder;
  do {
    cylinder.point = drawPoint(random, -1.0, 1.0);
    cylinder.axis = drawDirection(random, 1.0);
    cylinder.radius = random.uniform(0.05, 1.0);
  } while (std::abs(cylinder.axis.z()) > 0.8);
  return {cylinder, [cylinder](double x, double y) { return cylinderHeight(cylinder, x, y); }};
}

inline double coneHeight(const Cone& cone, double length, double x, double y) {
  // (p.a)^2 = cos^2 |p|^2 along p = (dx, dy, t); t is the height over the apex.
  const double dx = x - cone.apex.x(), dy = y - cone.apex.y();
  const double along = dx * cone.axis.x() + dy * cone.axis.y(), axis_z = cone.axis.z();
  const double cosine_sq = std::cos(cone.half_angle) * std::cos(cone.half_angle);
  const double a = cosine_sq - axis_z * axis_z, b = -along * axis_z;
  const double c = cosine_sq * (dx * dx + dy * dy) - along * along;
  // a > 0: both roots on one nappe, the upper surface is the larger. a < 0, a body that hangs down: the larger root is
  // on the mirrored nappe above the apex, the body's surface is the smaller; both are the same expression.
  if (std::abs(a) < 1e-12) return kNothing;
  const double t = upperRoot(a, b, c);
  const double h = along + t * axis_z;
  const double z = cone.apex.z() + t;
  return 0.0 < h && h < length && z < kCeiling ? z : kNothing;
}

/// Apex in [-2, 2] x [-2, 2] x [0, 2], sine of the half angle in [sin 10 deg, sin 45 deg]; its inside is never seen
/// from above.
inline PaperObject drawCone(Random& random) {
  const double kDegree = std::acos(-1.0) / 180.0;
  Cone cone;
  double sine;
  do {
    cone.apex = drawPoint(random, 0.0, 2.0);
    cone.axis = drawDirection(random, 2.0);
    sine = random.uniform(std::sin(kDegree * 10.0), std::sin(kDegree * 45.0));
    cone.half_angle = std::asin(sine);
  } while (std::cos(cone.half_angle) < cone.axis.z());
  // Cut where the lateral area, the same for every half angle, is reached.
  const double cosine = std::cos(cone.half_angle);
  const double length = 0.8 * std::sqrt(2.0 * cosine * cosine / sine);
  return {cone, [cone, length](double x, double y) { return coneHeight(cone, length, x, y); }};
}

/// Seen from its upper side.
inline PaperObject triangleObject(std::array<Vec3, 3> corners) {
  Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (normal.z() < 0.0) {
    std::swap(corners[1], corners[2]);
    normal = -normal;
  }
  const Plane plane{corners[0], normal.normalized()};
  return {plane, [plane, corners](double x, double y) {
            for (int k = 0; k < 3; ++k) {
              const Vec3 &from = corners[k], &to = corners[(k + 1) % 3];
              const double side = (to.x() - from.x()) * (y - from.y()) - (to.y() - from.y()) * (x - from.x());
              if (side < 0.0) return kNothing;
            }
            const double dx = x - plane.point.x(), dy = y - plane.point.y();
            return plane.point.z() - (plane.normal.x() * dx + plane.normal.y() * dy) / plane.normal.z();
          }};
}

/// Corners in [-2, 2] x [-2, 2] x [0, 2].
inline PaperObject drawTriangle(Random& random) {
  std::array<Vec3, 3> corners;
  for (Vec3& corner : corners) corner = drawPoint(random, 0.0, 2.0);
  return triangleObject(corners);
}

}  // namespace primitect::synthetic
