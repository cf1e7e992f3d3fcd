// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Distances of points with their gradients by a shape's local parameters, and steps along these: what least squares
// needs.
#pragma once

#include <Eigen/Core>

#include "primitect/primitives.h"

namespace primitect {

/// Local parameters of a shape, zero at the shape itself; unused ones keep a gradient of 0. Metres and radians.
///   plane     turn of the normal (2), shift along it
///   sphere    centre (3), radius
///   cylinder  point across the axis (2), turn of the axis (2), radius
///   cone      apex (3), turn of the axis (2), half angle
constexpr int kMostParameters = 6;
using Gradient = Eigen::Matrix<double, kMostParameters, 1>;
using Hessian = Eigen::Matrix<double, kMostParameters, kMostParameters>;

/// How many of them a kind has: 3, 4, 5, 6.
constexpr int parameterCount(Kind kind) { return 3 + static_cast<int>(kind); }

/// Signed distance of a point (m) and its derivative by the local parameters.
struct Residual {
  double distance;
  Gradient gradient;
};

Residual residual(const Plane& plane, const Vec3& p);
Residual residual(const Sphere& sphere, const Vec3& p);
Residual residual(const Cylinder& cylinder, const Vec3& p);
Residual residual(const Cone& cone, const Vec3& p);
Residual residual(const Shape& shape, const Vec3& p);

/// The shape a step away in its local parameters; it may have left its limits (a radius below 0).
Plane stepped(const Plane& plane, const Gradient& step);
Sphere stepped(const Sphere& sphere, const Gradient& step);
Cylinder stepped(const Cylinder& cylinder, const Gradient& step);
Cone stepped(const Cone& cone, const Gradient& step);

/// The two directions across a unit vector along which it turns.
struct Turn {
  Vec3 first, second;
  explicit Turn(const Vec3& axis);
  Vec3 turned(const Vec3& axis, double a, double b) const { return (axis + a * first + b * second).normalized(); }
};

}  // namespace primitect
