// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gradients and steps of the four kinds; see residuals.h.
#include "core/residuals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace primitect {

Turn::Turn(const Vec3& axis) : first(axis.unitOrthogonal()), second(axis.cross(first)) {}

Residual PlaneResiduals::operator()(const Vec3& p) const {
  const Vec3 q = p - plane_.point;
  Residual r{q.dot(plane_.normal), Gradient::Zero()};
  r.gradient.head<3>() << q.dot(turn_.first), q.dot(turn_.second), -1.0;
  return r;
}
Plane stepped(const Plane& plane, const Gradient& step) {
  const Turn turn(plane.normal);
  return {plane.point + step[2] * plane.normal, turn.turned(plane.normal, step[0], step[1])};
}

Residual SphereResiduals::operator()(const Vec3& p) const {
  const Vec3 q = p - sphere_.center;
  const double away = q.norm();
  Residual r{away - sphere_.radius, Gradient::Zero()};
  r.gradient.head<3>() = away > 0.0 ? Vec3(-q / away) : Vec3(-Vec3::UnitZ());
  r.gradient[3] = -1.0;
  return r;
}
Sphere stepped(const Sphere& sphere, const Gradient& step) {
  return {sphere.center + step.head<3>(), sphere.radius + step[3]};
}

Residual CylinderResiduals::operator()(const Vec3& p) const {
  const Vec3 q = p - cylinder_.point;
  const double height = q.dot(cylinder_.axis);
  double first = q.dot(turn_.first), second = q.dot(turn_.second);
  const double away = std::sqrt(first * first + second * second);
  first = away > 0.0 ? first / away : 1.0;
  second = away > 0.0 ? second / away : 0.0;
  Residual r{away - cylinder_.radius, Gradient::Zero()};
  r.gradient.head<5>() << -first, -second, -height * first, -height * second, -1.0;
  return r;
}
Cylinder stepped(const Cylinder& cylinder, const Gradient& step) {
  const Turn turn(cylinder.axis);
  return {cylinder.point + step[0] * turn.first + step[1] * turn.second, turn.turned(cylinder.axis, step[2], step[3]),
          cylinder.radius + step[4]};
}

Residual ConeResiduals::operator()(const Vec3& p) const {
  const Vec3 q = p - cone_.apex;
  const double height = q.dot(cone_.axis);
  double first = q.dot(turn_.first), second = q.dot(turn_.second);
  const double radius = std::sqrt(first * first + second * second);
  first = radius > 0.0 ? first / radius : 1.0;
  second = radius > 0.0 ? second / radius : 0.0;
  // Along the slant from the apex to the foot point.
  const double slant = height * cosine_ + radius * sine_;
  Residual r{radius * cosine_ - height * sine_, Gradient::Zero()};
  r.gradient.head<3>() = sine_ * cone_.axis - cosine_ * (first * turn_.first + second * turn_.second);
  r.gradient.tail<3>() << -first * slant, -second * slant, -slant;
  return r;
}
Cone stepped(const Cone& cone, const Gradient& step) {
  const Turn turn(cone.axis);
  const double half_angle = cone.half_angle + step[5];
  const double along = step.head<3>().dot(cone.axis);
  // The circle that stays where it is by the linear step does so exactly: the apex of a slender cone is far away, and
  // not linear in the angle.
  const double wanted = std::abs(step[5]) > 1e-9
                            ? along * std::sin(cone.half_angle) * std::sin(step[5]) / (step[5] * std::sin(half_angle))
                            : along;
  const Vec3 apex = cone.apex + step.head<3>() + (wanted - along) * cone.axis;
  return {apex, turn.turned(cone.axis, step[3], step[4]), half_angle};
}

Circle circleBeside(const Vec3& beside, const Cone& cone) {
  const double height = (beside - cone.apex).dot(cone.axis);
  return {cone.apex + height * cone.axis, height * std::tan(cone.half_angle)};
}

Cone steppedBeside(const Vec3& beside, const Cone& cone, const Gradient& step) {
  const Turn turn(cone.axis);
  const Circle circle = circleBeside(beside, cone);
  const Vec3 middle = circle.middle + step[0] * turn.first + step[1] * turn.second;
  const double radius = circle.radius + step[4], angle = cone.half_angle + step[5];
  Vec3 axis = turn.turned(cone.axis, step[2], step[3]);
  if (angle < 0.0) axis = -axis;
  const double half_angle = std::max(std::abs(angle), kLeastHalfAngle);
  return {middle - radius / std::tan(half_angle) * axis, axis, radius > 0.0 ? half_angle : -half_angle};
}

Residual residual(const Shape& shape, const Vec3& p) {
  return std::visit([&p](const auto& s) { return residualsOf(s)(p); }, shape);
}

}  // namespace primitect
