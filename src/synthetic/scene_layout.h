// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where things stand on a table, and a camera that looks at them.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "synthetic/tabletop_objects.h"

namespace primitect::synthetic {

struct Place {
  Eigen::Vector2d center;  ///< m
  double yaw;              ///< rad
};

/// Points along the middle line of the object's stadium, dense enough to tell gaps of a few millimetres.
inline std::vector<Eigen::Vector2d> middleLine(const Object& object, const Place& place) {
  const Eigen::Vector2d direction(std::cos(place.yaw), std::sin(place.yaw));
  const int steps = object.half_line > 0.0 ? 12 : 0;
  std::vector<Eigen::Vector2d> points{place.center};
  for (int i = 0; i <= steps && steps > 0; ++i) {
    points.push_back(place.center + direction * object.half_line * (2.0 * i / steps - 1.0));
  }
  return points;
}

/// True when the stadiums are at least gap (m) apart.
inline bool apart(const Object& a, const Place& place_a, const Object& b, const Place& place_b, double gap) {
  const double least = a.radius + b.radius + gap;
  for (const Eigen::Vector2d& point_a : middleLine(a, place_a)) {
    for (const Eigen::Vector2d& point_b : middleLine(b, place_b)) {
      if ((point_a - point_b).squaredNorm() < least * least) return false;
    }
  }
  return true;
}

/// world_from_camera (optical frame) of a camera without roll; straight up or down with -y of the world to its right.
inline Eigen::Isometry3d lookAt(const Vec3& eye, const Vec3& target) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = eye;
  pose.linear().col(2) = (target - eye).normalized();
  const Vec3 right = pose.linear().col(2).cross(Vec3::UnitZ());
  pose.linear().col(0) = right.norm() > 1e-9 ? right.normalized() : Vec3(-Vec3::UnitY());
  pose.linear().col(1) = pose.linear().col(2).cross(pose.linear().col(0));
  return pose;
}

}  // namespace primitect::synthetic
