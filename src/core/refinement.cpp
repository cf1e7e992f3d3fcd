// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Robust Gauss-Newton on geometric distances: gradients and steps of the four kinds; see fitting.h.
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/fitting.h"

namespace primitect {
namespace {

/// At most six parameters; unused ones keep a gradient of 0.
using Gradient = Eigen::Matrix<double, 6, 1>;
using Hessian = Eigen::Matrix<double, 6, 6>;

/// Distance of a point and its derivative by the shape's local parameters.
struct Residual {
  double distance;
  Gradient gradient;
};

/// Two directions across a unit vector, along which it can turn.
struct Turn {
  Vec3 first, second;
  explicit Turn(const Vec3& axis) : first(axis.unitOrthogonal()), second(axis.cross(first)) {}
  Vec3 turned(const Vec3& axis, double a, double b) const { return (axis + a * first + b * second).normalized(); }
};

/// Parameters: normal along Turn (2), shift along the normal.
Residual residual(const Plane& plane, const Vec3& p) {
  const Turn turn(plane.normal);
  const Vec3 q = p - plane.point;
  Residual r{distance(plane, p), Gradient::Zero()};
  r.gradient.head<3>() << q.dot(turn.first), q.dot(turn.second), -1.0;
  return r;
}
Plane stepped(const Plane& plane, const Gradient& step) {
  const Turn turn(plane.normal);
  return {plane.point + step[2] * plane.normal, turn.turned(plane.normal, step[0], step[1])};
}

/// Parameters: centre (3), radius.
Residual residual(const Sphere& sphere, const Vec3& p) {
  Residual r{distance(sphere, p), Gradient::Zero()};
  r.gradient.head<3>() = -normalAt(sphere, p);
  r.gradient[3] = -1.0;
  return r;
}
Sphere stepped(const Sphere& sphere, const Gradient& step) {
  return {sphere.center + step.head<3>(), sphere.radius + step[3]};
}

/// Parameters: point across the axis (2), axis along Turn (2), radius.
Residual residual(const Cylinder& cylinder, const Vec3& p) {
  const Turn turn(cylinder.axis);
  const Vec3 out = normalAt(cylinder, p);
  const double height = (p - cylinder.point).dot(cylinder.axis);
  const double first = out.dot(turn.first), second = out.dot(turn.second);
  Residual r{distance(cylinder, p), Gradient::Zero()};
  r.gradient.head<5>() << -first, -second, -height * first, -height * second, -1.0;
  return r;
}
Cylinder stepped(const Cylinder& cylinder, const Gradient& step) {
  const Turn turn(cylinder.axis);
  return {cylinder.point + step[0] * turn.first + step[1] * turn.second, turn.turned(cylinder.axis, step[2], step[3]),
          cylinder.radius + step[4]};
}

/// Parameters: apex (3), axis along Turn (2), half angle.
Residual residual(const Cone& cone, const Vec3& p) {
  const Turn turn(cone.axis);
  const Vec3 q = p - cone.apex;
  const double height = q.dot(cone.axis);
  const Vec3 across = q - height * cone.axis;
  const double radius = across.norm();
  const double sine = std::sin(cone.half_angle), cosine = std::cos(cone.half_angle);
  // Along the slant from the apex to the foot point.
  const double slant = height * cosine + radius * sine;
  const Vec3 out = radius > 0.0 ? Vec3(across / radius) : turn.first;
  Residual r{radius * cosine - height * sine, Gradient::Zero()};
  r.gradient.head<3>() = -(cosine * out - sine * cone.axis);
  r.gradient.tail<3>() << -out.dot(turn.first) * slant, -out.dot(turn.second) * slant, -slant;
  return r;
}
Cone stepped(const Cone& cone, const Gradient& step) {
  const Turn turn(cone.axis);
  return {cone.apex + step.head<3>(), turn.turned(cone.axis, step[3], step[4]), cone.half_angle + step[5]};
}

bool usable(const Plane& plane) { return plane.point.allFinite() && plane.normal.allFinite(); }
bool usable(const Sphere& sphere) { return sphere.center.allFinite() && 0.0 < sphere.radius && sphere.radius < 1e6; }
bool usable(const Cylinder& cylinder) {
  return cylinder.point.allFinite() && cylinder.axis.allFinite() && 0.0 < cylinder.radius && cylinder.radius < 1e6;
}
bool usable(const Cone& cone) {
  return cone.apex.allFinite() && cone.axis.allFinite() && 0.0 < cone.half_angle && cone.half_angle < M_PI / 2.0;
}

template <class T>
std::optional<Shape> refineKind(T shape, const SampleSet& set, const std::function<double(const Vec3&)>& tolerance) {
  constexpr int kSteps = 10;
  constexpr double kSmallStep = 1e-7;  // m or rad: below any noise
  for (int iteration = 0; iteration < kSteps; ++iteration) {
    Hessian hessian = Hessian::Zero();
    Gradient right = Gradient::Zero();
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Vec3 p = set.point(k);
      const Residual r = residual(shape, p);
      const double limit = tolerance(p);
      const double share = r.distance / limit;
      if (!(std::abs(share) < 1.0)) continue;
      // Tukey's biweight; in units of the tolerance, so that far points of a depth camera count for less.
      const double root = (1.0 - share * share) / limit;
      hessian.selfadjointView<Eigen::Lower>().rankUpdate(r.gradient, root * root);
      right -= root * root * r.distance * r.gradient;
    }
    // Damped a little, which also holds parameters that this kind does not have.
    const double damping = 1e-9 * hessian.trace() + 1e-12;
    hessian.diagonal().array() += damping;
    const Gradient step = hessian.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    shape = stepped(shape, step);
    if (!usable(shape)) return std::nullopt;
    if (step.norm() < kSmallStep) break;
  }
  return shape;
}

}  // namespace

std::optional<Shape> refine(const Shape& start, const SampleSet& set,
                            const std::function<double(const Vec3&)>& tolerance) {
  return std::visit([&](const auto& shape) { return refineKind(shape, set, tolerance); }, start);
}

}  // namespace primitect
