// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The hall keeps what its header promises.
#include "synthetic/hall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "solids.h"
#include "synthetic/raycast.h"

namespace primitect::synthetic::hall_test {
namespace {

constexpr std::uint64_t kSeeds = 40;
constexpr std::size_t kFirst = 3;  // after the floor and two walls

TEST(Hall, HoldsUpToNineThingsAndInTimeEveryKindOfThem) {
  std::map<std::string, int> seen;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World world = hall(seed);
    int things = 0;
    for (std::size_t i = kFirst; i < world.bodies().size(); ++i) {
      if (const Frustum* cone = std::get_if<Frustum>(&world.bodies()[i].solid)) {
        EXPECT_TRUE(cone->half_angle > 0.13 && cone->half_angle < 0.32) << cone->half_angle;
      }
      ++seen[world.bodies()[i].name];
      things += world.bodies()[i].name != "foot";
    }
    EXPECT_TRUE(things >= 1 && things <= 9) << seed << ": " << things;
  }
  EXPECT_EQ(seen["cone"], seen["foot"]);
  for (const char* name : {"cone", "sphere", "bin", "pillar", "tube", "crate", "ellipsoid", "lump"}) {
    EXPECT_GE(seen[name], 4) << name;
  }
}

TEST(Hall, EverythingStandsOnTheFloorOrOnItsFoot) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World world = hall(seed);
    for (std::size_t i = kFirst; i < world.bodies().size(); ++i) {
      const Body& body = world.bodies()[i];
      if (body.name == "lump") continue;  // its bumps reach anywhere
      const Box* foot = std::get_if<Box>(&world.bodies()[i - 1].solid);
      EXPECT_NEAR(lowestPoint(body), body.name == "cone" && foot ? 2.0 * foot->half_z : 0.0, 1e-8) << body.name;
    }
  }
}

TEST(Hall, NothingOverlapsAndTheCameraIsOutside) {
  Random random(5);
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World world = hall(seed);
    for (std::size_t i = kFirst; i < world.bodies().size(); ++i) {
      EXPECT_FALSE(contains(world.bodies()[i], hallPose(seed).translation()));
      for (const Vec3& p : pointsInside(world.bodies()[i], 100, random)) {
        EXPECT_GT(p.x(), hallPose(seed).translation().x()) << "before the camera";
        for (std::size_t other = kFirst; other < world.bodies().size(); ++other) {
          if (other == i) continue;
          ASSERT_FALSE(contains(world.bodies()[other], p)) << world.bodies()[i].name << ", seed " << seed;
        }
      }
    }
  }
}

TEST(Hall, IsSeenWithThingsThatTheBorderCuts) {
  const PinholeCamera camera{160, 120, 142.6, 142.6, 79.5, 59.5};
  int frames_with_things = 0, cut = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World world = hall(seed);
    Rendering rendering;
    render(world, camera, hallPose(seed), rendering);
    std::map<int, std::pair<int, bool>> bodies;  // pixels, whether some are at the border
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        const int surface = rendering.surface[static_cast<std::size_t>(v) * camera.width + u];
        if (surface == kNoSurface || world.surfaces()[surface].body < static_cast<int>(kFirst)) continue;
        auto& [pixels, at_border] = bodies[world.surfaces()[surface].body];
        ++pixels;
        at_border = at_border || u == 0 || v == 0 || u == camera.width - 1 || v == camera.height - 1;
      }
    }
    frames_with_things += bodies.size() >= 2;
    for (const auto& [body, seen] : bodies) cut += seen.first > 60 && seen.second;
  }
  EXPECT_GE(frames_with_things, 32) << "of 40";
  EXPECT_GE(cut, 30);
}

TEST(Hall, IsTheSameForTheSameSeedOnly) {
  const World first = hall(1), again = hall(1), other = hall(2);
  ASSERT_EQ(again.bodies().size(), first.bodies().size());
  const auto poseOfFirstThing = [](const World& world) { return world.bodies()[kFirst].world_from_body; };
  EXPECT_TRUE(poseOfFirstThing(again).isApprox(poseOfFirstThing(first), 0.0));
  EXPECT_FALSE(poseOfFirstThing(other).isApprox(poseOfFirstThing(first), 1e-6));
  EXPECT_TRUE(hallPose(1).isApprox(hallPose(1), 0.0));
  EXPECT_FALSE(hallPose(1).isApprox(hallPose(2), 1e-6));
}

}  // namespace
}  // namespace primitect::synthetic::hall_test
