// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes as the loops over many points take them: in float, around an origin near those points.
#pragma once

#include <cmath>

#include "core/residuals.h"
#include "kernels/loops.h"
#include "primitect/primitives.h"

namespace primitect {

inline void setPlace(const Vec3& place, kernels::FlatShape& flat) {
  flat.x = static_cast<float>(place.x());
  flat.y = static_cast<float>(place.y());
  flat.z = static_cast<float>(place.z());
}

inline void setDirection(const Vec3& direction, kernels::FlatShape& flat) {
  flat.dx = static_cast<float>(direction.x());
  flat.dy = static_cast<float>(direction.y());
  flat.dz = static_cast<float>(direction.z());
}

inline kernels::FlatShape flattened(const Plane& plane, const Vec3& origin) {
  kernels::FlatShape flat;
  flat.kind = kernels::FlatShape::plane;
  setPlace(plane.point - origin, flat);
  setDirection(plane.normal, flat);
  return flat;
}

inline kernels::FlatShape flattened(const Sphere& sphere, const Vec3& origin) {
  kernels::FlatShape flat;
  flat.kind = kernels::FlatShape::sphere;
  setPlace(sphere.center - origin, flat);
  flat.radius = static_cast<float>(sphere.radius);
  return flat;
}

inline kernels::FlatShape flattened(const Cylinder& cylinder, const Vec3& origin) {
  kernels::FlatShape flat;
  flat.kind = kernels::FlatShape::cylinder;
  setPlace(cylinder.point - origin, flat);
  setDirection(cylinder.axis, flat);
  flat.radius = static_cast<float>(cylinder.radius);
  return flat;
}

inline kernels::FlatShape flattened(const Cone& cone, const Vec3& origin) {
  kernels::FlatShape flat;
  flat.kind = kernels::FlatShape::cone;
  setPlace(cone.apex - origin, flat);
  setDirection(cone.axis, flat);
  flat.sine = static_cast<float>(std::sin(cone.half_angle));
  flat.cosine = static_cast<float>(std::cos(cone.half_angle));
  return flat;
}

inline kernels::FlatShape flattened(const Shape& shape, const Vec3& origin) {
  return std::visit([&origin](const auto& s) { return flattened(s, origin); }, shape);
}

/// For fits: a cone by its circle beside a point (m), as nothing near the points is told by an apex far away; the other
/// kinds as they are.
template <class T>
kernels::FlatShape flattenedBeside(const Vec3&, const T& shape, const Vec3& origin) {
  return flattened(shape, origin);
}
inline kernels::FlatShape flattenedBeside(const Vec3& beside, const Cone& cone, const Vec3& origin) {
  kernels::FlatShape flat = flattened(cone, origin);
  const Circle circle = circleBeside(beside, cone);
  setPlace(circle.middle - origin, flat);
  flat.radius = static_cast<float>(circle.radius);
  return flat;
}
inline kernels::FlatShape flattenedBeside(const Vec3& beside, const Shape& shape, const Vec3& origin) {
  return std::visit([&](const auto& s) { return flattenedBeside(beside, s, origin); }, shape);
}

inline kernels::FlatTurn flattened(const Turn& turn) {
  const Eigen::Vector3f first = turn.first.cast<float>(), second = turn.second.cast<float>();
  return {first.x(), first.y(), first.z(), second.x(), second.y(), second.z()};
}

}  // namespace primitect
