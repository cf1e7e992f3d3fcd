// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What there is to see: bodies made of surfaces, each surface with its exact shape.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "primitect/primitives.h"
#include "synthetic/soft_solids.h"

namespace primitect::synthetic {

/// The solids in their own frame, lengths in m. The order of the surfaces of each is given with it.

/// Rectangle in the plane z = 0, seen from both sides. Surface: 0.
struct Sheet {
  double half_x, half_y;
};

/// Block around the origin. Surfaces: the sides at -x, +x, -y, +y, -z, +z.
struct Box {
  double half_x, half_y, half_z;
};

/// Sphere around the origin. Surface: 0.
struct Ball {
  double radius;
};

/// Cylinder along z around the origin. Surfaces: mantle, cap at -z, cap at +z.
struct Rod {
  double radius, half_length;
};

/// Cone with its apex (possibly cut off) at the origin, along +z from begin to end, half_angle in rad.
/// Surfaces: mantle, cap at end, and when begin > 0: cap at begin.
struct Frustum {
  double half_angle, begin, end;
};

/// Cup along z around the origin, open at +z: a rod with a bore that ends base above the bottom.
/// Surfaces: outer mantle, bottom, rim, inner mantle (concave), inside bottom.
struct Cup {
  double radius, inner_radius, half_length, base;
};

/// Conical cup, open at the wide end: a frustum along +z from begin to end with a cone of the same half angle, moved
/// by the wall (across the mantle), taken out from floor to end.
/// Surfaces: outer mantle, bottom at begin, rim at end, inner mantle (concave), inside bottom at floor.
struct Pot {
  double half_angle, begin, end, wall, floor;
  /// Height of the apex of the inner cone.
  double innerApex() const;
};

/// Spherical shell around the origin, open at +z: cut off at z = rim, and below to stand on a disc at z = foot, which
/// is within the shell: -radius < foot < -inner_radius. Surfaces: outside, inside (concave), rim, foot.
struct Bowl {
  double radius, inner_radius, rim, foot;
};

/// The following, and those of soft_solids.h, are none of the four kinds: their surface has no shape.

/// Surface: 0.
struct Ellipsoid {
  double half_x, half_y, half_z;
};

/// Ring around z. Surface: 0.
struct Torus {
  double ring_radius, tube_radius;
};

/// A ball with bumps: in the direction d it reaches to radius * (1 + bump * waves(d)), waves within [-1, 1] the mean of
/// three sines along x, y and z. Surface: 0.
struct Lump {
  double radius, bump, frequency, phase;  ///< bump in (0, 0.3], frequency in rad per unit of d, phase in rad
  double reach(const Vec3& direction) const;
};

using Solid = std::variant<Sheet, Box, Ball, Rod, Frustum, Cup, Pot, Bowl, Ellipsoid, Torus, Lump, Cloth, Leaf, Limbs>;

struct Body {
  std::string name;
  Solid solid;
  Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();
  int first_surface = 0;  ///< index in World::surfaces()
  int surface_count = 0;
  Vec3 corner_min, corner_max;  ///< bounding box in the body's frame (m)
};

/// One face of a body; normals of shapes point out of the body unless it is concave.
struct Surface {
  Shape shape;            ///< in the world frame; says nothing when primitive is false
  int body = 0;           ///< index in World::bodies()
  bool concave = false;   ///< the body is around the shape, not in it: normalAt(shape) points into the body
  bool primitive = true;  ///< false: a surface that is none of the four kinds
};

/// Bodies and their surfaces; the index of a surface is its label in rendered images.
class World {
 public:
  /// Adds a body and returns its index. Throws std::invalid_argument naming the body when a length is not positive,
  /// an angle is not in (0, 90) deg, or a wall leaves no room inside.
  int add(const std::string& name, const Solid& solid, const Eigen::Isometry3d& world_from_body);

  const std::vector<Body>& bodies() const& { return bodies_; }
  const std::vector<Surface>& surfaces() const& { return surfaces_; }
  // Of a temporary world, as in for (... : tabletop(1).bodies()), nothing would be left to look at.
  const std::vector<Body>& bodies() const&& = delete;
  const std::vector<Surface>& surfaces() const&& = delete;

 private:
  std::vector<Body> bodies_;
  std::vector<Surface> surfaces_;
};

}  // namespace primitect::synthetic
