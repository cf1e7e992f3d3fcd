// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Rendered depth against the definition of the solids.
#include "synthetic/raycast.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "solids.h"

namespace primitect::synthetic::raycast_test {
namespace {

const PinholeCamera kSmallCamera{160, 120, 142.6, 142.6, 79.5, 59.5};
const Eigen::Isometry3d kAtOrigin = Eigen::Isometry3d::Identity();

const std::vector<Solid> kSolids = {Sheet{0.15, 0.1},         Box{0.12, 0.08, 0.05},   Ball{0.1},
                                    Rod{0.06, 0.12},          Frustum{0.4, 0.0, 0.25}, Frustum{0.3, 0.1, 0.3},
                                    Frustum{1.3, 0.01, 0.04}, Frustum{0.01, 1.0, 1.2}, Rod{0.15, 0.01}};

/// A random pose with the middle of the solid at this position.
Eigen::Isometry3d posedAt(const Vec3& position, const Solid& solid, Random& random) {
  const Frustum* frustum = std::get_if<Frustum>(&solid);
  const double middle = frustum ? 0.5 * (frustum->begin + frustum->end) : 0.0;
  return randomPose(position, random) * Eigen::Translation3d(0.0, 0.0, -middle);
}

/// Depth of the nearest inside point along a pixel's ray, by walking around 1.2 m; 0 when there is none.
double walk(const Body& body, const Vec3& ray, double step) {
  for (double depth = 0.9; depth < 1.5; depth += step) {
    if (contains(body, depth * ray)) return depth;
  }
  return 0.0;
}

Vec3 pointAt(const Rendering& rendering, const PinholeCamera& camera, int u, int v) {
  return camera.ray(u, v) * static_cast<double>(rendering.depth[v * camera.width + u]);
}

TEST(Raycast, DepthLiesOnTheShapeOfItsSurface) {
  Random random(1);
  for (const Solid& solid : kSolids) {
    int seen = 0;
    for (int turn = 0; turn < 20; ++turn) {
      // A camera anywhere, the body in front of it.
      const Eigen::Isometry3d camera_pose = randomPose({0.3, -0.2, 0.1}, random);
      World world;
      world.add("body", solid, camera_pose * posedAt({0.05, -0.05, 1.0}, solid, random));
      Rendering rendering;
      render(world, kSmallCamera, camera_pose, rendering);
      for (int v = 0; v < kSmallCamera.height; ++v) {
        for (int u = 0; u < kSmallCamera.width; ++u) {
          const int surface = rendering.surface[v * kSmallCamera.width + u];
          if (surface == kNoSurface) continue;
          const Vec3 p = camera_pose * pointAt(rendering, kSmallCamera, u, v);
          // Float depths near 1 m are 6e-8 m apart.
          ASSERT_NEAR(distance(world.surfaces()[surface].shape, p), 0.0, 1e-5) << "kind " << solid.index();
          ++seen;
        }
      }
    }
    EXPECT_GT(seen, 1000) << "solid " << solid.index();
  }
}

TEST(Raycast, AgreesWithWalkingAlongTheRay) {
  constexpr double kStep = 0.002;
  Random random(2);
  for (const Solid& solid : kSolids) {
    if (std::holds_alternative<Sheet>(solid)) continue;
    for (int turn = 0; turn < 4; ++turn) {
      World world;
      world.add("body", solid, posedAt({0.05, 0.0, 1.2}, solid, random));
      Rendering rendering;
      render(world, kSmallCamera, kAtOrigin, rendering);
      for (int v = 0; v < kSmallCamera.height; v += 5) {
        for (int u = 0; u < kSmallCamera.width; u += 5) {
          const double walked = walk(world.bodies()[0], kSmallCamera.ray(u, v), kStep);
          const float depth = rendering.depth[v * kSmallCamera.width + u];
          if (walked == 0.0) {
            // Walking steps over a body that is met for less than a step: then just behind the hit is the outside.
            const bool cut_short =
                std::isnan(depth) || !contains(world.bodies()[0], kSmallCamera.ray(u, v) * (depth + kStep));
            ASSERT_TRUE(cut_short) << "solid " << solid.index() << " pixel " << u << ' ' << v;
          } else if (std::abs(depth - walked) > kStep) {
            // A corner cut for less than a step before the walk came inside: the hit must still be nearer.
            ASSERT_LT(depth, walked) << "solid " << solid.index() << " pixel " << u << ' ' << v;
            ASSERT_FALSE(contains(world.bodies()[0], kSmallCamera.ray(u, v) * (depth - 1e-5)));
          }
        }
      }
    }
  }
}

TEST(Raycast, SheetIsHitInsideOfItsBordersOnly) {
  World world;
  world.add("sheet", Sheet{0.2, 0.1}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 1.0)));
  Rendering rendering;
  render(world, kSmallCamera, kAtOrigin, rendering);
  for (int v = 0; v < kSmallCamera.height; ++v) {
    for (int u = 0; u < kSmallCamera.width; ++u) {
      const Vec3 p = kSmallCamera.ray(u, v);
      const bool inside = std::abs(p.x()) <= 0.2 && std::abs(p.y()) <= 0.1;
      ASSERT_EQ(rendering.surface[v * kSmallCamera.width + u] != kNoSurface, inside);
    }
  }
}

TEST(Raycast, NearerBodyHidesTheFartherInEitherOrder) {
  const Eigen::Isometry3d near_pose(Eigen::Translation3d(0.0, 0.0, 0.8));
  const Eigen::Isometry3d far_pose(Eigen::Translation3d(0.05, 0.0, 1.4));
  for (const bool near_first : {true, false}) {
    World world;
    const int first = world.add("first", Ball{0.1}, near_first ? near_pose : far_pose);
    const int second = world.add("second", Ball{0.3}, near_first ? far_pose : near_pose);
    const int nearer = near_first ? first : second;
    Rendering rendering;
    render(world, kSmallCamera, kAtOrigin, rendering);
    const std::size_t center = 60 * 160 + 80;
    EXPECT_EQ(rendering.surface[center], world.bodies()[nearer].first_surface);
    const double radius = near_first ? 0.1 : 0.3;
    EXPECT_NEAR(rendering.depth[center], 0.8 - radius, 1e-4);
  }
}

TEST(Raycast, NothingInFrontMeansMissing) {
  World world;
  world.add("behind", Ball{0.1}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, -1.0)));
  Rendering rendering;
  render(world, kSmallCamera, kAtOrigin, rendering);
  for (std::size_t i = 0; i < rendering.depth.size(); ++i) {
    ASSERT_TRUE(std::isnan(rendering.depth[i]));
    ASSERT_EQ(rendering.surface[i], kNoSurface);
  }
}

TEST(Raycast, SheetThatPassesBehindTheCameraIsStillSeen) {
  World world;
  const Eigen::Isometry3d floor(Eigen::Translation3d(0.0, 1.0, 0.0) * Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()));
  world.add("floor", Sheet{50.0, 50.0}, floor);
  Rendering rendering;
  render(world, kSmallCamera, kAtOrigin, rendering);
  const double slope = kSmallCamera.ray(80, 119).y();
  EXPECT_NEAR(rendering.depth[119 * 160 + 80], 1.0 / slope, 1e-5);
  EXPECT_TRUE(std::isnan(rendering.depth[10 * 160 + 80]));
}

TEST(World, RefusesImpossibleBodies) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  World world;
  EXPECT_THROW(world.add("b", Ball{0.0}, kAtOrigin), std::invalid_argument);
  EXPECT_THROW(world.add("b", Ball{nan}, kAtOrigin), std::invalid_argument);
  EXPECT_THROW(world.add("b", Box{0.1, -0.1, 0.1}, kAtOrigin), std::invalid_argument);
  EXPECT_THROW(world.add("b", Rod{0.1, 0.0}, kAtOrigin), std::invalid_argument);
  EXPECT_THROW(world.add("b", Frustum{1.6, 0.0, 1.0}, kAtOrigin), std::invalid_argument);
  EXPECT_THROW(world.add("b", Frustum{0.5, 0.3, 0.2}, kAtOrigin), std::invalid_argument);
  EXPECT_TRUE(world.bodies().empty());
  EXPECT_TRUE(world.surfaces().empty());
}

TEST(World, SurfaceNormalsPointOutOfTheBody) {
  Random random(3);
  for (const Solid& solid : kSolids) {
    if (std::holds_alternative<Sheet>(solid)) continue;
    World world;
    world.add("body", solid, randomPose({0.3, 0.2, 0.1}, random));
    for (const Vec3& p : pointsInside(world.bodies()[0], 100, random)) {
      for (const Surface& surface : world.surfaces()) ASSERT_LT(distance(surface.shape, p), 0.0);
    }
  }
}

}  // namespace
}  // namespace primitect::synthetic::raycast_test
