// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Errors kind by kind; see parameter_errors.h.
#include "eval/parameter_errors.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>

namespace primitect::eval {
namespace {

constexpr double kRadianInDegrees = 180.0 / 3.14159265358979323846;

/// By the half-angle tangent: exact for small angles too, where an arc cosine is not.
double angleDeg(const Vec3& a, const Vec3& b) {
  return kRadianInDegrees * 2.0 * std::atan2((a - b).norm(), (a + b).norm());
}

double lineAngleDeg(const Vec3& a, const Vec3& b) { return a.dot(b) < 0.0 ? angleDeg(a, -b) : angleDeg(a, b); }

/// From the point of the true axis next to the place to the axis that was found.
double axisOffset(const Cylinder& truth, const Cylinder& found, const Vec3& place) {
  const Vec3 on_axis = truth.point + (place - truth.point).dot(truth.axis) * truth.axis;
  return (on_axis - found.point).cross(found.axis).norm();
}

void add(const Plane& truth, const Plane& found, const Vec3& place, ParameterErrors& errors) {
  errors.position.push_back(std::abs(distance(found, project(truth, place))));
  errors.axis_deg.push_back(lineAngleDeg(truth.normal, found.normal));
}

void add(const Sphere& truth, const Sphere& found, const Vec3&, ParameterErrors& errors) {
  errors.position.push_back((truth.center - found.center).norm());
  errors.radius.push_back(std::abs(truth.radius - found.radius));
}

void add(const Cylinder& truth, const Cylinder& found, const Vec3& place, ParameterErrors& errors) {
  errors.position.push_back(axisOffset(truth, found, place));
  errors.radius.push_back(std::abs(truth.radius - found.radius));
  errors.axis_deg.push_back(lineAngleDeg(truth.axis, found.axis));
}

void add(const Cone& truth, const Cone& found, const Vec3&, ParameterErrors& errors) {
  errors.apex.push_back((truth.apex - found.apex).norm());
  errors.axis_deg.push_back(angleDeg(truth.axis, found.axis));
  errors.half_angle_deg.push_back(kRadianInDegrees * std::abs(truth.half_angle - found.half_angle));
}

}  // namespace

void addErrors(const Shape& truth, const Shape& found, const Vec3& place, ParameterErrors& errors) {
  if (kindOf(truth) != kindOf(found)) {
    throw std::invalid_argument(std::string("parameter errors: a ") + kindName(kindOf(found)) + " compared with a " +
                                kindName(kindOf(truth)));
  }
  std::visit([&](const auto& shape) { add(shape, std::get<std::decay_t<decltype(shape)>>(found), place, errors); },
             truth);
}

}  // namespace primitect::eval
