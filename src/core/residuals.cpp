// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gradients and steps of the four kinds; see residuals.h.
#include "core/residuals.h"

#include <Eigen/Geometry>
#include <cmath>

namespace primitect {

Turn::Turn(const Vec3& axis) : first(axis.unitOrthogonal()), second(axis.cross(first)) {}

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

Residual residual(const Sphere& sphere, const Vec3& p) {
  Residual r{distance(sphere, p), Gradient::Zero()};
  r.gradient.head<3>() = -normalAt(sphere, p);
  r.gradient[3] = -1.0;
  return r;
}
Sphere stepped(const Sphere& sphere, const Gradient& step) {
  return {sphere.center + step.head<3>(), sphere.radius + step[3]};
}

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

Residual residual(const Shape& shape, const Vec3& p) {
  return std::visit([&p](const auto& s) { return residual(s, p); }, shape);
}

}  // namespace primitect
