// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the tests know about solids, worked out apart from the code they test: inside, lowest point, surface points.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

/// Solid test by its definition, in the solid's frame; a sheet has no inside.
struct Contains {
  Vec3 p;
  double radial() const { return std::hypot(p.x(), p.y()); }
  bool operator()(const Sheet&) const { return false; }
  bool operator()(const Box& b) const {
    return std::abs(p.x()) < b.half_x && std::abs(p.y()) < b.half_y && std::abs(p.z()) < b.half_z;
  }
  bool operator()(const Ball& b) const { return p.norm() < b.radius; }
  bool operator()(const Rod& r) const { return radial() < r.radius && std::abs(p.z()) < r.half_length; }
  bool operator()(const Frustum& f) const {
    return p.z() > f.begin && p.z() < f.end && std::atan2(radial(), p.z()) < f.half_angle;
  }
};

inline bool contains(const Body& body, const Vec3& p_world) {
  return std::visit(Contains{body.world_from_body.inverse() * p_world}, body.solid);
}

/// Height of the lowest point: the support of the body downwards.
struct LowestPoint {
  const Eigen::Isometry3d& pose;
  double discBelow(double along, double radius) const {
    const double up = pose.linear()(2, 2);
    return pose.translation().z() + along * up - radius * std::sqrt(std::max(0.0, 1.0 - up * up));
  }
  double operator()(const Sheet& s) const { return (*this)(Box{s.half_x, s.half_y, 0.0}); }
  double operator()(const Box& b) const {
    return pose.translation().z() - std::abs(pose.linear()(2, 0)) * b.half_x -
           std::abs(pose.linear()(2, 1)) * b.half_y - std::abs(pose.linear()(2, 2)) * b.half_z;
  }
  double operator()(const Ball& b) const { return pose.translation().z() - b.radius; }
  double operator()(const Rod& r) const {
    return std::min(discBelow(-r.half_length, r.radius), discBelow(r.half_length, r.radius));
  }
  double operator()(const Frustum& f) const {
    const double slope = std::tan(f.half_angle);
    return std::min(discBelow(f.begin, f.begin * slope), discBelow(f.end, f.end * slope));
  }
};

inline double lowestPoint(const Body& body) { return std::visit(LowestPoint{body.world_from_body}, body.solid); }

/// Random points just inside of a body (m, world), found by trying points of its bounding box.
inline std::vector<Vec3> pointsInside(const Body& body, int count, Random& random) {
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(body.corner_min[axis], body.corner_max[axis]);
    if (std::visit(Contains{p}, body.solid)) points.push_back(body.world_from_body * p);
  }
  return points;
}

inline Eigen::Isometry3d randomPose(const Vec3& position, Random& random) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position;
  Eigen::Quaterniond turn(random.gaussian(), random.gaussian(), random.gaussian(), random.gaussian());
  pose.linear() = turn.normalized().toRotationMatrix();
  return pose;
}

}  // namespace primitect::synthetic
