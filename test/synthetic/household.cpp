// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The table with things of several parts keeps what its header promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "solids.h"
#include "synthetic/clutter.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic::household_test {
namespace {

constexpr int kSeeds = 40;

const std::vector<World>& worlds() {
  static const std::vector<World> made = [] {
    std::vector<World> result;
    for (int seed = 1; seed <= kSeeds; ++seed) result.push_back(householdTable(static_cast<std::uint64_t>(seed)));
    return result;
  }();
  return made;
}

bool isThing(const Body& body) { return body.name != "floor" && body.name != "wall" && body.name != "table"; }

/// Of the body's axis, from the horizontal (0) to the vertical (1).
double uprightness(const Body& body) { return std::abs(body.world_from_body.linear()(2, 2)); }

double radiusOf(const Body& body) { return std::get<Rod>(body.solid).radius; }

/// Stands on the one before it.
bool standsOn(const Body& body, const Body& below) {
  constexpr double kTouches = 1e-8;  // m
  const Box* box = std::get_if<Box>(&below.solid);
  const Rod* rod = std::get_if<Rod>(&below.solid);
  const Frustum* frustum = std::get_if<Frustum>(&below.solid);
  const double half = box       ? box->half_z
                      : rod     ? rod->half_length
                      : frustum ? 0.5 * (frustum->end - frustum->begin)
                                : 0.0;
  return std::abs(lowestPoint(body) - (lowestPoint(below) + 2.0 * half)) < kTouches;
}

TEST(HouseholdTable, HasInTimeEveryThingInAllWays) {
  std::map<std::string, int> seen;
  for (const World& world : worlds()) {
    for (const Body& body : world.bodies()) {
      ++seen[body.name];
      if (uprightness(body) < 1e-9) ++seen[body.name + " lying"];
    }
  }
  for (const char* name : {"jar",    "bottle",    "spray can",    "flower pot",     "tin", "can",    "book",     "mug",
                           "handle", "lid",       "shoulder",     "neck",           "rim", "sphere", "cylinder", "cone",
                           "box",    "jar lying", "bottle lying", "spray can lying"}) {
    EXPECT_GE(seen[name], 2) << name;
  }
  EXPECT_EQ(seen["mug"], seen["handle"]);
  EXPECT_EQ(seen["flower pot"], seen["rim"]);
  EXPECT_EQ(seen["jar"] + seen["bottle"] + seen["spray can"], seen["shoulder"]);
}

TEST(HouseholdTable, EverythingStandsOnTheTableOrOnThePartBelow) {
  for (const World& world : worlds()) {
    for (std::size_t i = 0; i < world.bodies().size(); ++i) {
      const Body& body = world.bodies()[i];
      if (!isThing(body) || body.name == "handle" || uprightness(body) < 1.0 - 1e-9) continue;
      const bool on_table = std::abs(lowestPoint(body) - kTableHeight) < 1e-8;
      EXPECT_TRUE(on_table || standsOn(body, world.bodies()[i - 1])) << body.name;
    }
  }
}

TEST(HouseholdTable, WhatLiesTouchesTheTableWithItsWidestPart) {
  int lying = 0;
  for (const World& world : worlds()) {
    for (const Body& body : world.bodies()) {
      if (!isThing(body) || uprightness(body) > 1e-9 || !std::holds_alternative<Rod>(body.solid)) continue;
      const bool widest = body.name == "jar" || body.name == "bottle" || body.name == "spray can";
      lying += widest;
      const double low = lowestPoint(body) - kTableHeight;
      if (widest) {
        EXPECT_NEAR(low, 0.0, 1e-8) << body.name;
      } else if (body.name == "lid" || body.name == "neck") {
        EXPECT_GT(low, 0.0009) << body.name;
      }
    }
  }
  EXPECT_GE(lying, 9);
}

TEST(HouseholdTable, CansOnEachOtherDifferByFourMillimetres) {
  int piled = 0;
  for (const World& world : worlds()) {
    for (std::size_t i = 1; i < world.bodies().size(); ++i) {
      const Body &body = world.bodies()[i], &below = world.bodies()[i - 1];
      if (body.name != "can" || below.name != "can" || !standsOn(body, below)) continue;
      ++piled;
      EXPECT_GE(std::abs(radiusOf(body) - radiusOf(below)), 0.004);
      const Vec3 aside = body.world_from_body.translation() - below.world_from_body.translation();
      EXPECT_LT(aside.head<2>().norm(), 0.0043) << "one does not stand on the other";
    }
  }
  EXPECT_GE(piled, 10);
}

TEST(HouseholdTable, NothingOverlapsButHandlesAndTheirMugs) {
  Random random(5);
  for (const World& world : worlds()) {
    for (const Body& body : world.bodies()) {
      if (!isThing(body)) continue;
      for (const Vec3& p : pointsInside(body, 100, random)) {
        for (const Body& other : world.bodies()) {
          const bool mug = body.name == "handle" ? other.name == "mug" : body.name == "mug" && other.name == "handle";
          if (&other == &body || mug) continue;
          ASSERT_FALSE(contains(other, p)) << body.name << " in " << other.name;
        }
      }
    }
  }
}

TEST(HouseholdTable, HandlesDoNotReachThroughTheWall) {
  Random random(6);
  int handles = 0;
  for (const World& world : worlds()) {
    for (std::size_t i = 1; i < world.bodies().size(); ++i) {
      if (world.bodies()[i].name != "handle") continue;
      const Body& mug = world.bodies()[i - 1];
      const double inside = std::get<Cup>(mug.solid).inner_radius;
      ++handles;
      int in_wall = 0;
      for (const Vec3& p : pointsInside(world.bodies()[i], 2000, random)) {
        const Vec3 in_mug = mug.world_from_body.inverse() * p;
        EXPECT_GT(in_mug.head<2>().norm(), inside);
        in_wall += contains(mug, p);
      }
      EXPECT_GT(in_wall, 0) << "it hangs in the air";
    }
  }
  EXPECT_GE(handles, 5);
}

TEST(HouseholdTable, IsTheSameForTheSameSeedOnly) {
  const World again = householdTable(1);
  ASSERT_EQ(again.bodies().size(), worlds()[0].bodies().size());
  const Eigen::Isometry3d last = again.bodies().back().world_from_body;
  EXPECT_TRUE(last.isApprox(worlds()[0].bodies().back().world_from_body, 0.0));
  EXPECT_FALSE(last.isApprox(worlds()[1].bodies().back().world_from_body, 1e-6));
}

}  // namespace
}  // namespace primitect::synthetic::household_test
