// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Takes solids apart into surfaces with exact shapes.
#include "synthetic/world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "primitect/transforms.h"
#include "synthetic/solid_limits.h"

namespace primitect::synthetic {
namespace {

/// Surfaces and bounding box of a solid in its own frame.
struct Parts {
  std::vector<Surface> surfaces;
  Vec3 corner_min, corner_max;

  void convex(const Shape& shape) { surfaces.push_back({shape, 0, false, true}); }
  void concave(const Shape& shape) { surfaces.push_back({shape, 0, true, true}); }
  void shapeless() { surfaces.push_back({Plane{}, 0, false, false}); }
  /// Planes across z, with the normal up or down.
  void faceUp(double z) { convex(Plane{z * Vec3::UnitZ(), Vec3::UnitZ()}); }
  void faceDown(double z) { convex(Plane{z * Vec3::UnitZ(), -Vec3::UnitZ()}); }
};

Parts symmetricParts(const Vec3& half_size) { return {{}, -half_size, half_size}; }

Parts partsOf(const Sheet& sheet) {
  Parts parts = symmetricParts({sheet.half_x, sheet.half_y, 0.0});
  parts.convex(Plane{Vec3::Zero(), Vec3::UnitZ()});
  return parts;
}

Parts partsOf(const Box& box) {
  Parts parts = symmetricParts({box.half_x, box.half_y, box.half_z});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 normal = side * Vec3::Unit(axis);
      parts.convex(Plane{normal * parts.corner_max[axis], normal});
    }
  }
  return parts;
}

Parts partsOf(const Ball& ball) {
  Parts parts = symmetricParts(Vec3::Constant(ball.radius));
  parts.convex(Sphere{Vec3::Zero(), ball.radius});
  return parts;
}

Parts partsOf(const Rod& rod) {
  Parts parts = symmetricParts({rod.radius, rod.radius, rod.half_length});
  parts.convex(Cylinder{Vec3::Zero(), Vec3::UnitZ(), rod.radius});
  parts.faceDown(-rod.half_length);
  parts.faceUp(rod.half_length);
  return parts;
}

Parts partsOf(const Frustum& frustum) {
  const double radius = frustum.end * std::tan(frustum.half_angle);
  Parts parts{{}, Vec3(-radius, -radius, frustum.begin), Vec3(radius, radius, frustum.end)};
  parts.convex(Cone{Vec3::Zero(), Vec3::UnitZ(), frustum.half_angle});
  parts.faceUp(frustum.end);
  if (frustum.begin > 0.0) parts.faceDown(frustum.begin);
  return parts;
}

Parts partsOf(const Cup& cup) {
  Parts parts = symmetricParts({cup.radius, cup.radius, cup.half_length});
  parts.convex(Cylinder{Vec3::Zero(), Vec3::UnitZ(), cup.radius});
  parts.faceDown(-cup.half_length);
  parts.faceUp(cup.half_length);
  parts.concave(Cylinder{Vec3::Zero(), Vec3::UnitZ(), cup.inner_radius});
  parts.faceUp(cup.base - cup.half_length);
  return parts;
}

Parts partsOf(const Pot& pot) {
  const double radius = pot.end * std::tan(pot.half_angle);
  Parts parts{{}, Vec3(-radius, -radius, pot.begin), Vec3(radius, radius, pot.end)};
  parts.convex(Cone{Vec3::Zero(), Vec3::UnitZ(), pot.half_angle});
  parts.faceDown(pot.begin);
  parts.faceUp(pot.end);
  parts.concave(Cone{pot.innerApex() * Vec3::UnitZ(), Vec3::UnitZ(), pot.half_angle});
  parts.faceUp(pot.floor);
  return parts;
}

Parts partsOf(const Bowl& bowl) {
  const double widest = bowl.rim >= 0.0 ? bowl.radius : std::sqrt(bowl.radius * bowl.radius - bowl.rim * bowl.rim);
  Parts parts{{}, Vec3(-widest, -widest, bowl.foot), Vec3(widest, widest, bowl.rim)};
  parts.convex(Sphere{Vec3::Zero(), bowl.radius});
  parts.concave(Sphere{Vec3::Zero(), bowl.inner_radius});
  parts.faceUp(bowl.rim);
  parts.faceDown(bowl.foot);
  return parts;
}

Parts shapelessParts(const Vec3& half_size) {
  Parts parts = symmetricParts(half_size);
  parts.shapeless();
  return parts;
}

Parts partsOf(const Ellipsoid& e) { return shapelessParts({e.half_x, e.half_y, e.half_z}); }

Parts partsOf(const Torus& torus) {
  const double reach = torus.ring_radius + torus.tube_radius;
  return shapelessParts({reach, reach, torus.tube_radius});
}

Parts partsOf(const Lump& lump) { return shapelessParts(Vec3::Constant(lump.radius * (1.0 + lump.bump))); }

Parts partsOf(const Cloth& cloth) { return shapelessParts({cloth.half_x, cloth.half_y, cloth.highest()}); }

Parts partsOf(const Leaf& leaf) { return shapelessParts({leaf.half_x, leaf.half_y, leaf.highest()}); }

Parts partsOf(const Limbs& limbs) {
  Parts parts = shapelessParts(Vec3::Zero());
  for (const Limbs::Limb& limb : limbs.limbs) {
    const Vec3 widest = Vec3::Constant(std::max(limb.radius_from, limb.radius_to) + limbs.blend);
    parts.corner_min = parts.corner_min.cwiseMin(limb.from.cwiseMin(limb.to) - widest);
    parts.corner_max = parts.corner_max.cwiseMax(limb.from.cwiseMax(limb.to) + widest);
  }
  return parts;
}

}  // namespace

double Pot::innerApex() const { return wall / std::sin(half_angle); }

double Lump::reach(const Vec3& d) const {
  const double waves = std::sin(frequency * d.x() + phase) + std::sin(frequency * d.y() + 2.0 * phase) +
                       std::sin(frequency * d.z() + 3.0 * phase);
  return radius * (1.0 + bump * waves / 3.0);
}

int World::add(const std::string& name, const Solid& solid, const Eigen::Isometry3d& world_from_body) {
  if (!std::visit([](const auto& s) { return isPossible(s); }, solid)) {
    throw std::invalid_argument("body '" + name +
                                "': lengths must be above 0 m, angles between 0 and 90 deg, with room inside of walls");
  }
  const Parts parts = std::visit([](const auto& s) { return partsOf(s); }, solid);
  const int index = static_cast<int>(bodies_.size());
  Body body{name,
            solid,
            world_from_body,
            static_cast<int>(surfaces_.size()),
            static_cast<int>(parts.surfaces.size()),
            parts.corner_min,
            parts.corner_max};
  for (Surface surface : parts.surfaces) {
    surface.shape = transformed(world_from_body, surface.shape);
    surface.body = index;
    surfaces_.push_back(std::move(surface));
  }
  bodies_.push_back(std::move(body));
  return index;
}

}  // namespace primitect::synthetic
