// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What there is to see: bodies made of surfaces, each surface with its exact shape.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "primitect/primitives.h"

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

using Solid = std::variant<Sheet, Box, Ball, Rod, Frustum>;

struct Body {
  std::string name;
  Solid solid;
  Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();
  int first_surface = 0;  ///< index in World::surfaces()
  int surface_count = 0;
  Vec3 corner_min, corner_max;  ///< bounding box in the body's frame (m)
};

/// One face of a body; normals point out of the body.
struct Surface {
  Shape shape;  ///< in the world frame
  int body;     ///< index in World::bodies()
};

/// The same shape in another frame.
Shape transformed(const Eigen::Isometry3d& target_from_source, const Shape& shape);

/// Bodies and their surfaces; the index of a surface is its label in rendered images.
class World {
 public:
  /// Adds a body and returns its index. Throws std::invalid_argument naming the body when a length is not positive
  /// or an angle is not in (0, 90) deg.
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
