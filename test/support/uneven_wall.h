// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A wall with waves behind a table without.
#pragma once

#include <cmath>
#include <cstddef>

#include "synthetic/world.h"
#include "test/support/exact_shapes.h"
#include "test/support/rendered_cloud.h"

namespace primitect::test {

constexpr double kUnevenWall = 1.7;  // m, z

/// A table close by, which reaches into the lower half of the image, and a wall with three crossing waves of .15 m that
/// strays from its plane by this much (m, standard deviation).
inline synthetic::World tableAndUnevenWall(double waves) {
  constexpr double kLength = 0.15, kThick = 0.004;  // m
  synthetic::World world;
  const Eigen::Isometry3d table = tableBeforeCamera(0.75, 50.0 * kDegree);
  world.add("table", synthetic::Sheet{0.4, 0.25}, table * Eigen::Translation3d(0.0, -0.2, 0.0));
  synthetic::Cloth wall = {2.0, 2.0, kThick, {}};
  for (std::size_t k = 0; k < wall.waves.size(); ++k) {
    const double heading = 2.1 * static_cast<double>(k) + 0.4, turn = 2.0 * M_PI / kLength;
    wall.waves[k] = {turn * std::cos(heading), turn * std::sin(heading), std::sqrt(2.0 / 3.0) * waves,
                     static_cast<double>(k)};
  }
  world.add("wall", wall, Eigen::Translation3d(0.0, 0.0, kUnevenWall) * Eigen::Isometry3d::Identity());
  return world;
}

}  // namespace primitect::test
