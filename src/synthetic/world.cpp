// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Takes solids apart into surfaces with exact shapes.
#include "synthetic/world.h"

#include <cmath>
#include <stdexcept>

namespace primitect::synthetic {
namespace {

constexpr double kHalfPi = 1.57079632679489661923;

/// Surfaces and bounding box of a solid in its own frame.
struct Parts {
  std::vector<Shape> shapes;
  Vec3 corner_min, corner_max;
};

Parts symmetricParts(const Vec3& half_size) { return {{}, -half_size, half_size}; }

Parts partsOf(const Sheet& sheet) {
  Parts parts = symmetricParts({sheet.half_x, sheet.half_y, 0.0});
  parts.shapes.push_back(Plane{Vec3::Zero(), Vec3::UnitZ()});
  return parts;
}

Parts partsOf(const Box& box) {
  Parts parts = symmetricParts({box.half_x, box.half_y, box.half_z});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 normal = side * Vec3::Unit(axis);
      parts.shapes.push_back(Plane{normal * parts.corner_max[axis], normal});
    }
  }
  return parts;
}

Parts partsOf(const Ball& ball) {
  Parts parts = symmetricParts(Vec3::Constant(ball.radius));
  parts.shapes.push_back(Sphere{Vec3::Zero(), ball.radius});
  return parts;
}

Parts partsOf(const Rod& rod) {
  Parts parts = symmetricParts({rod.radius, rod.radius, rod.half_length});
  parts.shapes.push_back(Cylinder{Vec3::Zero(), Vec3::UnitZ(), rod.radius});
  parts.shapes.push_back(Plane{-rod.half_length * Vec3::UnitZ(), -Vec3::UnitZ()});
  parts.shapes.push_back(Plane{rod.half_length * Vec3::UnitZ(), Vec3::UnitZ()});
  return parts;
}

Parts partsOf(const Frustum& frustum) {
  const double radius = frustum.end * std::tan(frustum.half_angle);
  Parts parts{{}, Vec3(-radius, -radius, frustum.begin), Vec3(radius, radius, frustum.end)};
  parts.shapes.push_back(Cone{Vec3::Zero(), Vec3::UnitZ(), frustum.half_angle});
  parts.shapes.push_back(Plane{frustum.end * Vec3::UnitZ(), Vec3::UnitZ()});
  if (frustum.begin > 0.0) parts.shapes.push_back(Plane{frustum.begin * Vec3::UnitZ(), -Vec3::UnitZ()});
  return parts;
}

/// Written so that NaN and infinity fail.
bool isLength(double value) { return value > 0.0 && std::isfinite(value); }

bool isPossible(const Sheet& s) { return isLength(s.half_x) && isLength(s.half_y); }
bool isPossible(const Box& b) { return isLength(b.half_x) && isLength(b.half_y) && isLength(b.half_z); }
bool isPossible(const Ball& b) { return isLength(b.radius); }
bool isPossible(const Rod& r) { return isLength(r.radius) && isLength(r.half_length); }
bool isPossible(const Frustum& f) {
  return f.half_angle > 0.0 && f.half_angle < kHalfPi && f.begin >= 0.0 && f.begin < f.end && isLength(f.end);
}

struct Transform {
  const Eigen::Isometry3d& target_from_source;

  Vec3 turn(const Vec3& direction) const { return target_from_source.linear() * direction; }

  Shape operator()(const Plane& p) const { return Plane{target_from_source * p.point, turn(p.normal)}; }
  Shape operator()(const Sphere& s) const { return Sphere{target_from_source * s.center, s.radius}; }
  Shape operator()(const Cylinder& c) const { return Cylinder{target_from_source * c.point, turn(c.axis), c.radius}; }
  Shape operator()(const Cone& c) const { return Cone{target_from_source * c.apex, turn(c.axis), c.half_angle}; }
};

}  // namespace

Shape transformed(const Eigen::Isometry3d& target_from_source, const Shape& shape) {
  return std::visit(Transform{target_from_source}, shape);
}

int World::add(const std::string& name, const Solid& solid, const Eigen::Isometry3d& world_from_body) {
  if (!std::visit([](const auto& s) { return isPossible(s); }, solid)) {
    throw std::invalid_argument("body '" + name + "': lengths must be above 0 m, angles between 0 and 90 deg");
  }
  const Parts parts = std::visit([](const auto& s) { return partsOf(s); }, solid);
  const int index = static_cast<int>(bodies_.size());
  Body body{name,
            solid,
            world_from_body,
            static_cast<int>(surfaces_.size()),
            static_cast<int>(parts.shapes.size()),
            parts.corner_min,
            parts.corner_max};
  for (const Shape& shape : parts.shapes) surfaces_.push_back({transformed(world_from_body, shape), index});
  bodies_.push_back(std::move(body));
  return index;
}

}  // namespace primitect::synthetic
