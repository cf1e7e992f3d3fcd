// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a depth camera sees of a ball before a wall.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/random.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::test {

/// Of a 640 x 480 camera with 570 px focal length every so many-th pixel; 1 mm of noise along the rays.
struct BallAndWall {
  int every = 2;
  double wall = 1.2;  ///< m, z
  Sphere ball = {Vec3(0.05, 0.02, 1.0), 0.1};

  Cloud image(std::uint64_t seed) const {
    const int columns = 640 / every, rows = 480 / every;
    const double focal = 570.0 / every;
    Random random(seed);
    Cloud cloud;
    cloud.reset(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), false);
    for (int i = 0; i < columns * rows; ++i) {
      const Vec3 ray((i % columns - 0.5 * (columns - 1)) / focal, (i / columns - 0.5 * (rows - 1)) / focal, 1.0);
      const double b = ray.dot(ball.center) / ray.squaredNorm();
      const double c = (ball.center.squaredNorm() - ball.radius * ball.radius) / ray.squaredNorm();
      const double depth = (b * b > c ? b - std::sqrt(b * b - c) : wall) + 0.001 * random.gaussian();
      const Eigen::Vector3f p = (depth * ray).cast<float>();
      cloud.setPoint(static_cast<std::size_t>(i), p.x(), p.y(), p.z(), {});
    }
    return cloud;
  }

  /// Of the surface that a point (m) was seen on.
  Vec3 normalAt(const Vec3& point) const {
    return point.z() < wall - 0.1 ? Vec3((point - ball.center).normalized()) : Vec3(-Vec3::UnitZ());
  }

  /// How many pixels of an image are not on the wall.
  double onBall(const Cloud& image) const {
    const auto nearer = [this](float z) { return z < wall - 0.1; };
    return static_cast<double>(std::count_if(image.z.begin(), image.z.end(), nearer));
  }
};

}  // namespace primitect::test
