// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Poses of things that stand or lie on a table and of a camera above a floor, and the angles that they are written in.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/degree.h"

namespace primitect::synthetic {

constexpr double kPi = 3.14159265358979323846;
using primitect::kDegree;

/// Upright, moved by x and z (m) from the place on the table; the table is at z = 0.
inline Eigen::Isometry3d at(double x, double z) { return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, z)); }

/// z of the solid's frame turned towards x by this angle (rad) from up.
inline Eigen::Isometry3d tilted(double angle) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
}

/// A robot's frame on the floor below its camera: x ahead, y to the left, z up. The camera's optical frame is this high
/// above it (m) and turned down by this angle (rad) from looking ahead.
inline Eigen::Isometry3d robotFromCamera(double height, double down) {
  const Eigen::Vector3d right = -Eigen::Vector3d::UnitY();
  const Eigen::Vector3d ahead(std::cos(down), 0.0, -std::sin(down));
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() << right, ahead.cross(right), ahead;
  result.translation().z() = height;
  return result;
}

}  // namespace primitect::synthetic
