// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Solids made from simple ones by adding and cutting, and points on what is left of their faces.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "core/random.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

/// A solid and where it is.
struct Placed {
  Solid solid;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/// A point of the boundary with its exact normal, out of the material.
struct BoundaryPoint {
  Vec3 point, normal;
  int surface;  ///< index in Csg::surfaces()
};

/// Material, step by step: each step adds a solid or cuts one away. Boxes, balls, rods and frusta only.
class Csg {
 public:
  /// Throw std::invalid_argument for other solids, or ones that World::add() refuses.
  void add(const Placed& placed, const Eigen::Isometry3d& frame = Eigen::Isometry3d::Identity());
  void cut(const Placed& placed, const Eigen::Isometry3d& frame = Eigen::Isometry3d::Identity());

  /// The point is within the material; undefined on the boundary itself.
  bool inside(const Vec3& p) const;

  /// Faces of all steps, whether or not something is left of them. Those of cuts are concave if they are curved, and
  /// plane ones have their normal turned out of the material.
  const std::vector<Surface>& surfaces() const { return surfaces_; }

  /// Points spread evenly over the boundary, each drawn for itself. Where faces of two steps fall together, the points
  /// are those of the earlier. Throws std::runtime_error when (nearly) nothing is left.
  std::vector<BoundaryPoint> sampleBoundary(std::size_t count, Random& random) const;

 private:
  struct Step {
    Solid solid;
    Eigen::Isometry3d world_from_body, body_from_world;
    bool cuts;
    int first_surface;
  };

  void append(const Placed& placed, const Eigen::Isometry3d& frame, bool cuts);
  bool isVisible(const BoundaryPoint& sample, std::size_t step) const;

  std::vector<Step> steps_;
  std::vector<Surface> surfaces_;  ///< Surface::body is the index of the step
};

}  // namespace primitect::synthetic
