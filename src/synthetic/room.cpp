// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sheets and a board; see room.h.
#include "synthetic/room.h"

#include "synthetic/poses.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic {

void addFloor(World& world) { world.add("floor", Sheet{6.0, 6.0}, Eigen::Isometry3d::Identity()); }

void addWall(double distance, double yaw, World& world) {
  world.add("wall", Sheet{1.5, 6.0},
            Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::Translation3d(distance, 0.0, 1.5) *
                Eigen::Isometry3d(Eigen::AngleAxisd(-kPi / 2, Vec3::UnitY())));
}

void addTable(double half_x, double half_y, World& world) {
  constexpr double kThickness = 0.03;
  world.add("table", Box{half_x, half_y, kThickness / 2},
            Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, kTableHeight - kThickness / 2)));
}

}  // namespace primitect::synthetic
