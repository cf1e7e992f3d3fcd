// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The tabletop keeps what its header promises, for many seeds and all of the camera's swing.
#include "synthetic/tabletop.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "solids.h"
#include "synthetic/camera.h"
#include "synthetic/raycast.h"

namespace primitect::synthetic::tabletop_test {
namespace {

constexpr int kSeeds = 50;

/// The worlds of the seeds from 0 to kSeeds - 1, made once for all tests.
const World& worldOf(int seed) {
  static const std::vector<World> worlds = [] {
    std::vector<World> made;
    for (int i = 0; i < kSeeds; ++i) made.push_back(tabletop(static_cast<std::uint64_t>(i)));
    return made;
  }();
  return worlds[static_cast<std::size_t>(seed)];
}

bool onTable(const Body& body) { return body.name != "floor" && body.name != "wall" && body.name != "table"; }

TEST(Tabletop, HoldsThePromisedNumberOfEachKind) {
  std::set<std::map<std::string, int>> inventories;
  for (int seed = 0; seed < kSeeds; ++seed) {
    std::map<std::string, int> count;
    const World& world = worldOf(seed);
    for (const Body& body : world.bodies()) ++count[body.name];
    for (const char* name : {"floor", "wall", "table"}) EXPECT_EQ(count[name], 1);
    for (const char* name : {"sphere", "cylinder"}) EXPECT_TRUE(count[name] == 2 || count[name] == 3) << seed;
    for (const char* name : {"cone", "box"}) EXPECT_TRUE(count[name] == 1 || count[name] == 2) << seed;
    inventories.insert(count);
  }
  EXPECT_GE(inventories.size(), 8u);
}

TEST(Tabletop, KeepsSizesWithinTheirRangesAndUsesBothPoses) {
  int lying_rods = 0, standing_rods = 0, lying_cones = 0, standing_cones = 0, pointed = 0, blunt = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World& world = worldOf(seed);
    for (const Body& body : world.bodies()) {
      const bool standing = std::abs(body.world_from_body.linear()(2, 2)) > 0.999;
      if (const Ball* ball = std::get_if<Ball>(&body.solid)) {
        EXPECT_GE(ball->radius, 0.025);
        EXPECT_LE(ball->radius, 0.090);
      } else if (const Rod* rod = std::get_if<Rod>(&body.solid)) {
        EXPECT_GE(rod->radius, 0.025);
        EXPECT_LE(rod->radius, 0.090);
        ++(standing ? standing_rods : lying_rods);
      } else if (const Frustum* cone = std::get_if<Frustum>(&body.solid)) {
        EXPECT_GE(cone->half_angle, 10.0 * M_PI / 180.0);
        EXPECT_LE(cone->half_angle, 35.0 * M_PI / 180.0);
        const double radius = cone->end * std::tan(cone->half_angle);
        EXPECT_GE(radius, 0.025);
        EXPECT_LE(radius, 0.090 + 1e-9);
        ++(standing ? standing_cones : lying_cones);
        ++(cone->begin > 0.0 ? blunt : pointed);
      }
    }
  }
  for (const int count : {lying_rods, standing_rods, lying_cones, standing_cones, pointed, blunt}) EXPECT_GE(count, 8);
}

TEST(Tabletop, EverythingStandsOnTheTableAndWithinItsBorders) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World& world = worldOf(seed);
    for (const Body& body : world.bodies()) {
      if (!onTable(body)) continue;
      // The square root in the support of a disc turns rounding of 1e-16 into 1e-8 of its radius.
      EXPECT_NEAR(lowestPoint(body), kTableHeight, 1e-8) << body.name << ", seed " << seed;
      EXPECT_LT(body.world_from_body.translation().head<2>().norm(), 0.6) << body.name << ", seed " << seed;
    }
    EXPECT_NEAR(world.bodies()[2].world_from_body.translation().z() + std::get<Box>(world.bodies()[2].solid).half_z,
                kTableHeight, 1e-12);
  }
}

TEST(Tabletop, NothingOverlaps) {
  Random random(5);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World& world = worldOf(seed);
    for (const Body& body : world.bodies()) {
      if (!onTable(body)) continue;
      for (const Vec3& p : pointsInside(body, 2000, random)) {
        for (const Body& other : world.bodies()) {
          if (&other == &body) continue;
          ASSERT_FALSE(contains(other, p)) << body.name << " in " << other.name << ", seed " << seed;
        }
      }
    }
  }
}

/// Pixels of each surface.
std::vector<int> countPixels(const World& world, const Rendering& rendering) {
  std::vector<int> count(world.surfaces().size(), 0);
  for (const int surface : rendering.surface) {
    if (surface != kNoSurface) ++count[surface];
  }
  return count;
}

TEST(Tabletop, EveryObjectIsVisibleAndUncutForAMinute) {
  const PinholeCamera camera;
  for (int seed = 0; seed < 8; ++seed) {
    const World& world = worldOf(seed);
    Rendering rendering;
    for (double seconds = 0.0; seconds <= 60.0; seconds += 2.7) {
      render(world, camera, cameraPose(seconds), rendering);
      const std::vector<int> count = countPixels(world, rendering);
      for (const Body& body : world.bodies()) {
        if (!onTable(body)) continue;
        int pixels = count[body.first_surface];
        if (body.name == "box") pixels = *std::max_element(&count[body.first_surface], &count[body.first_surface] + 6);
        EXPECT_GE(pixels, body.name == "box" ? 300 : 900) << body.name << ", seed " << seed << ", s " << seconds;
      }
      for (int v = 0; v < camera.height; ++v) {
        for (int u = 0; u < camera.width; u += (v == 0 || v + 1 == camera.height) ? 1 : camera.width - 1) {
          const int surface = rendering.surface[v * camera.width + u];
          ASSERT_FALSE(onTable(world.bodies()[world.surfaces()[surface].body])) << "cut at " << u << ' ' << v;
        }
      }
    }
  }
}

TEST(Tabletop, FloorAndWallAreSeenBeyondTwoMetres) {
  const PinholeCamera camera;
  const World& world = worldOf(0);
  Rendering rendering;
  for (double seconds = 0.0; seconds <= 60.0; seconds += 1.9) {
    render(world, camera, cameraPose(seconds), rendering);
    const std::vector<int> count = countPixels(world, rendering);
    EXPECT_GT(count[0], 900);
    EXPECT_GT(count[1], 900);
    for (std::size_t i = 0; i < rendering.depth.size(); ++i) {
      if (rendering.surface[i] > 1) continue;
      ASSERT_GT(rendering.depth[i], 2.05f);
    }
  }
}

TEST(CameraPose, MovesSlowlyAndSmoothlyWithoutRoll) {
  double travelled = 0.0;
  for (double seconds = 0.0; seconds < 60.0; seconds += 1.0 / 30) {
    const Eigen::Isometry3d pose = cameraPose(seconds), next = cameraPose(seconds + 1.0 / 30);
    const double step = (next.translation() - pose.translation()).norm();
    travelled += step;
    EXPECT_LT(step, 0.15 / 30);
    EXPECT_LT(Eigen::AngleAxisd(pose.linear().transpose() * next.linear()).angle(), 0.15 / 30);
    EXPECT_NEAR(pose.linear()(2, 0), 0.0, 1e-12);
    EXPECT_LT(pose.linear()(2, 1), 0.0) << "image rows go down";
    EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-9);
    EXPECT_NEAR((pose.translation() - Vec3(0.0, 0.0, kTableHeight)).norm(), 1.03, 0.06);
  }
  EXPECT_GT(travelled, 2.0);
}

TEST(Tabletop, IsTheSameForTheSameSeedOnly) {
  const auto positions = [](std::uint64_t seed) {
    std::vector<double> numbers;
    const World world = tabletop(seed);
    for (const Body& body : world.bodies()) {
      const double* matrix = body.world_from_body.matrix().data();
      numbers.insert(numbers.end(), matrix, matrix + 16);
    }
    return numbers;
  };
  EXPECT_EQ(positions(9), positions(9));
  EXPECT_NE(positions(9), positions(10));
}

}  // namespace
}  // namespace primitect::synthetic::tabletop_test
