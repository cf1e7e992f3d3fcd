// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The cluttered table keeps what its header promises.
#include "synthetic/clutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "solids.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic::clutter_test {
namespace {

constexpr int kSeeds = 20;
const PinholeCamera kCoarseCamera{160, 120, 142.6, 142.6, 79.5, 59.5};

/// The worlds of the seeds from 0 to kSeeds - 1, made once for all tests.
const World& worldOf(int seed) {
  static const std::vector<World> worlds = [] {
    std::vector<World> made;
    for (int i = 0; i < kSeeds; ++i) made.push_back(clutteredTable(static_cast<std::uint64_t>(i)));
    return made;
  }();
  return worlds[static_cast<std::size_t>(seed)];
}

bool isThing(const Body& body) { return body.name != "floor" && body.name != "wall" && body.name != "table"; }
bool isShapeless(const World& world, const Body& body) { return !world.surfaces()[body.first_surface].primitive; }

TEST(ClutteredTable, HoldsThePromisedNumbersAndInTimeEveryKindOfThing) {
  std::map<std::string, int> seen;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World& world = worldOf(seed);
    int things = 0, shapeless = 0;
    for (const Body& body : world.bodies()) {
      if (!isThing(body)) continue;
      ++things;
      shapeless += isShapeless(world, body);
      ++seen[body.name];
    }
    EXPECT_TRUE(things >= 6 && things <= 14) << seed << ": " << things;
    EXPECT_TRUE(shapeless >= 1 && shapeless <= 3) << seed << ": " << shapeless;
  }
  for (const char* name : {"sphere", "cylinder", "cup", "bowl", "cone", "pot", "box", "ellipsoid", "torus", "lump"}) {
    EXPECT_GE(seen[name], 5) << name;
  }
}

TEST(ClutteredTable, UsesItsThingsInAllWays) {
  std::map<std::string, int> ways;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World& world = worldOf(seed);
    for (const Body& body : world.bodies()) {
      const double up = body.world_from_body.linear()(2, 2);
      ++ways[body.name + (up > 0.999 ? " upright" : up < -0.999 ? " upside down" : " lying")];
      if (const Frustum* cone = std::get_if<Frustum>(&body.solid)) ++ways[cone->begin > 0.0 ? "blunt" : "pointed"];
    }
  }
  for (const char* way : {"cylinder upright", "cylinder lying", "cup upright", "cup lying", "cone upside down",
                          "cone lying", "pot upright", "pot lying", "blunt", "pointed"}) {
    EXPECT_GE(ways[way], 2) << way;
  }
}

TEST(ClutteredTable, EverythingStandsOnTheTableOrOnABox) {
  int raised = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World& world = worldOf(seed);
    for (std::size_t i = 0; i < world.bodies().size(); ++i) {
      const Body& body = world.bodies()[i];
      if (!isThing(body)) continue;
      const double low = lowestPoint(body);
      double ground = kTableHeight;
      const Box* below = std::get_if<Box>(&world.bodies()[i - 1].solid);
      if (low > kTableHeight + 0.01 && below) {
        ground = world.bodies()[i - 1].world_from_body.translation().z() + below->half_z;
        ++raised;
      }
      // The lowest point of a lump is looked for on a grid.
      EXPECT_NEAR(low, ground, body.name == "lump" ? 1e-3 : 1e-8) << body.name << ", seed " << seed;
    }
  }
  EXPECT_GE(raised, 10);
}

TEST(ClutteredTable, NothingOverlaps) {
  Random random(5);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World& world = worldOf(seed);
    for (const Body& body : world.bodies()) {
      if (!isThing(body)) continue;
      for (const Vec3& p : pointsInside(body, 200, random)) {
        for (const Body& other : world.bodies()) {
          if (&other == &body) continue;
          ASSERT_FALSE(contains(other, p)) << body.name << " in " << other.name << ", seed " << seed;
        }
      }
    }
  }
}

/// Pixels of all surfaces of a body.
int pixelsOf(const Body& body, const World& world, const Eigen::Isometry3d& pose) {
  Rendering rendering;
  render(world, kCoarseCamera, pose, rendering);
  return std::count_if(rendering.surface.begin(), rendering.surface.end(), [&body](int surface) {
    return surface >= body.first_surface && surface < body.first_surface + body.surface_count;
  });
}

TEST(ClutteredTable, ManyThingsAreSeenAndSomeArePartlyHidden) {
  int things = 0, seen = 0, partly_hidden = 0;
  for (int seed = 0; seed < 10; ++seed) {
    const World& world = worldOf(seed);
    const Eigen::Isometry3d pose = clutterPose(seed);
    for (const Body& body : world.bodies()) {
      if (!isThing(body)) continue;
      World alone;
      alone.add(body.name, body.solid, body.world_from_body);
      const int visible = pixelsOf(body, world, pose), whole = pixelsOf(alone.bodies()[0], alone, pose);
      ++things;
      seen += visible > 30;
      partly_hidden += visible > 0.1 * whole && visible < 0.85 * whole;
    }
  }
  EXPECT_GT(seen, 0.8 * things);
  EXPECT_GT(partly_hidden, 0.1 * things);
}

TEST(ClutteredTable, TruthOfFramesHasEveryShapeBothWaysAndNothingShapeless) {
  int convex[kKindCount] = {}, concave[kKindCount] = {};
  for (int seed = 0; seed < 12; ++seed) {
    const World& world = worldOf(seed);
    const PinholeCamera camera;
    const Frame frame = renderFrame(world, camera, clutterPose(seed), {}, seed, 0);
    for (const Detection& item : frame.truth.items) ++(item.concave ? concave : convex)[item.shape.index()];
    std::set<int> shapeless;
    for (std::size_t i = 0; i < world.surfaces().size(); ++i) {
      if (!world.surfaces()[i].primitive) shapeless.insert(static_cast<int>(i));
    }
    Rendering rendering{frame.depth, frame.surface};
    std::vector<int> surface_of_item;
    truthOf(world, camera, clutterPose(seed), rendering, {}, &surface_of_item);
    EXPECT_EQ(surface_of_item.size(), frame.truth.items.size());
    for (const int surface : surface_of_item) EXPECT_EQ(shapeless.count(surface), 0u);
    const auto of_no_shape = [&](int surface) { return shapeless.count(surface) > 0; };
    EXPECT_GT(std::count_if(frame.surface.begin(), frame.surface.end(), of_no_shape), 500) << seed;
  }
  EXPECT_EQ(concave[0], 0);
  for (std::size_t kind = 0; kind < kKindCount; ++kind) EXPECT_GE(convex[kind], 3) << kind;
  for (std::size_t kind = 1; kind < kKindCount; ++kind) EXPECT_GE(concave[kind], 2) << kind;
}

TEST(ClutteredTable, HasItsWallBeyondTwoMetresMostOfTheTime) {
  int near = 0, far = 0;
  for (int seed = 0; seed < 60; ++seed) {
    const World world = clutteredTable(seed);
    Rendering rendering;
    render(world, kCoarseCamera, clutterPose(seed), rendering);
    float nearest = 10.0f;
    for (std::size_t i = 0; i < rendering.depth.size(); ++i) {
      if (rendering.surface[i] == kNoSurface) continue;
      const Body& body = world.bodies()[world.surfaces()[rendering.surface[i]].body];
      if (body.name == "wall") nearest = std::min(nearest, rendering.depth[i]);
    }
    ++(nearest < 2.0f ? near : far);
  }
  EXPECT_GE(near, 5);
  EXPECT_GT(far, near);
}

TEST(ClutterPose, LooksAtTheThingsFromWithinItsRanges) {
  for (int seed = 0; seed < 200; ++seed) {
    const Eigen::Isometry3d pose = clutterPose(seed);
    const Vec3 backwards = -pose.linear().col(2);
    const double pitch_deg = std::asin(backwards.z()) * 180.0 / M_PI;
    EXPECT_TRUE(pitch_deg > 25.0 && pitch_deg < 55.0) << pitch_deg;
    EXPECT_LT(std::abs(std::atan2(backwards.y(), -backwards.x())), 50.0 * M_PI / 180.0);
    EXPECT_LT(std::abs(pose.linear()(2, 0)), std::sin(5.0 * M_PI / 180.0)) << "roll";
    EXPECT_LT(pose.linear()(2, 1), 0.0) << "image rows go down";
    EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-9);
    const double distance = (pose.translation() - Vec3(0.0, 0.0, kTableHeight + 0.04)).norm();
    EXPECT_TRUE(distance > 0.8 - 0.08 && distance < 1.3 + 0.08) << distance;
  }
}

TEST(ClutteredTable, IsTheSameForTheSameSeedOnly) {
  const auto frameOf = [](std::uint64_t seed) {
    return renderFrame(clutteredTable(seed), kCoarseCamera, clutterPose(seed), {}, seed, 0);
  };
  const Frame first = frameOf(7), again = frameOf(7), other = frameOf(8);
  const std::size_t bytes = first.depth.size() * sizeof(float);
  EXPECT_EQ(std::memcmp(first.depth.data(), again.depth.data(), bytes), 0);
  EXPECT_EQ(first.surface, again.surface);
  EXPECT_NE(std::memcmp(first.depth.data(), other.depth.data(), bytes), 0);
}

TEST(ShapelessTable, HoldsNoCurvedShapeAndInTimeEveryKindOfThing) {
  std::map<std::string, int> seen;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World world = shapelessTable(static_cast<std::uint64_t>(seed));
    for (const Surface& surface : world.surfaces()) {
      EXPECT_TRUE(!surface.primitive || kindOf(surface.shape) == Kind::plane) << seed;
    }
    std::set<std::string> names;
    for (const Body& body : world.bodies()) names.insert(body.name);
    for (const std::string& name : names) ++seen[name];
  }
  for (const char* name : {"box", "ellipsoid", "torus", "lump", "cloth", "cable", "leaf", "hand"}) {
    EXPECT_GE(seen[name], 5) << name;
  }
}

TEST(ShapelessTable, NothingIsBelowTheTableTopOrFarAboveIt) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const World world = shapelessTable(static_cast<std::uint64_t>(seed));
    for (const Body& body : world.bodies()) {
      if (!isThing(body)) continue;
      const double above = lowestPoint(body) - kTableHeight;
      // Fingertips are round where a finger's two pieces end; leaves are up to 35 cm high.
      EXPECT_GT(above, -0.002) << body.name << ", seed " << seed;
      EXPECT_LT(above, body.name == "leaf" ? 0.35 : 0.03) << body.name << ", seed " << seed;
    }
  }
}

TEST(ShapelessTable, ShowsMoreThanItsTable) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const World world = shapelessTable(seed);
    Rendering rendering;
    render(world, kCoarseCamera, clutterPose(seed), rendering);
    const auto shapeless = std::count_if(rendering.surface.begin(), rendering.surface.end(), [&](int surface) {
      return surface != kNoSurface && !world.surfaces()[surface].primitive;
    });
    EXPECT_GT(shapeless, 0.03 * kCoarseCamera.pixelCount()) << seed;
  }
}

}  // namespace
}  // namespace primitect::synthetic::clutter_test
