// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Distances of points with their gradients by a shape's local parameters, and steps along these: what least squares
// needs.
#pragma once

#include <Eigen/Core>
#include <cmath>

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

/// The two directions across a unit vector along which it turns.
struct Turn {
  Vec3 first, second;
  explicit Turn(const Vec3& axis);
  Vec3 turned(const Vec3& axis, double a, double b) const { return (axis + a * first + b * second).normalized(); }
};

/// Signed distance of a point (m) and its derivative by the local parameters.
struct Residual {
  double distance;
  Gradient gradient;
};

/// Residuals of many points by one shape: what they share is worked out once.
class PlaneResiduals {
 public:
  explicit PlaneResiduals(const Plane& plane) : plane_(plane), turn_(plane.normal) {}
  Residual operator()(const Vec3& p) const;

 private:
  Plane plane_;
  Turn turn_;
};
class SphereResiduals {
 public:
  explicit SphereResiduals(const Sphere& sphere) : sphere_(sphere) {}
  Residual operator()(const Vec3& p) const;

 private:
  Sphere sphere_;
};
class CylinderResiduals {
 public:
  explicit CylinderResiduals(const Cylinder& cylinder) : cylinder_(cylinder), turn_(cylinder.axis) {}
  Residual operator()(const Vec3& p) const;

 private:
  Cylinder cylinder_;
  Turn turn_;
};
class ConeResiduals {
 public:
  explicit ConeResiduals(const Cone& cone)
      : cone_(cone), turn_(cone.axis), sine_(std::sin(cone.half_angle)), cosine_(std::cos(cone.half_angle)) {}
  Residual operator()(const Vec3& p) const;

 private:
  Cone cone_;
  Turn turn_;
  double sine_, cosine_;
};
inline PlaneResiduals residualsOf(const Plane& plane) { return PlaneResiduals(plane); }
inline SphereResiduals residualsOf(const Sphere& sphere) { return SphereResiduals(sphere); }
inline CylinderResiduals residualsOf(const Cylinder& cylinder) { return CylinderResiduals(cylinder); }
inline ConeResiduals residualsOf(const Cone& cone) { return ConeResiduals(cone); }

Residual residual(const Shape& shape, const Vec3& p);

/// The shape a step away in its local parameters; it may have left its limits (a radius below 0).
Plane stepped(const Plane& plane, const Gradient& step);
Sphere stepped(const Sphere& sphere, const Gradient& step);
Cylinder stepped(const Cylinder& cylinder, const Gradient& step);
Cone stepped(const Cone& cone, const Gradient& step);

/// A circle of a cone around its axis; radius below 0: behind the apex.
struct Circle {
  Vec3 middle;
  double radius;
};

/// At the height of this point (m).
Circle circleBeside(const Vec3& beside, const Cone& cone);

/// Half angle (rad) that a step does not go below: the apex is fifty radii away, and a cylinder as good.
constexpr double kLeastHalfAngle = 0.02;

/// The shape a step away in the parameters of its fit (kernels/loops.h): a cone's are those of its circle beside this
/// point (m). The apex and the angle of a slender cone far from its apex are neither linear in what moves the surface,
/// nor can float tell them apart. Tapered less than not at all, it opens the other way; half angle below 0: the circle
/// has shrunk to nothing.
Cone steppedBeside(const Vec3& beside, const Cone& cone, const Gradient& step);
/// The other kinds are fitted in their local parameters.
template <class T>
T steppedBeside(const Vec3&, const T& shape, const Gradient& step) {
  return stepped(shape, step);
}

}  // namespace primitect
