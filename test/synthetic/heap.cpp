// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The heap keeps what its header promises.
#include "synthetic/heap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "solids.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic::heap_test {
namespace {

constexpr int kSeeds = 12;
constexpr std::size_t kFirst = 2;  // after floor and table
constexpr double kSunken = 0.008;  // m

/// The worlds of the seeds from 1 on, made once for all tests.
const std::vector<World>& worlds() {
  static const std::vector<World> made = [] {
    std::vector<World> result;
    for (int seed = 1; seed <= kSeeds; ++seed) result.push_back(heap(static_cast<std::uint64_t>(seed)));
    return result;
  }();
  return made;
}

TEST(Heap, HoldsThePromisedNumbersAndInTimeEveryKindOfThingInAllPoses) {
  std::map<std::string, int> seen;
  int things = 0, askew = 0;
  for (const World& world : worlds()) {
    const std::size_t count = world.bodies().size() - kFirst;
    EXPECT_TRUE(count >= 12 && count <= 28) << count;
    int shapeless = 0;
    for (std::size_t i = kFirst; i < world.bodies().size(); ++i) {
      const Body& body = world.bodies()[i];
      shapeless += !world.surfaces()[body.first_surface].primitive;
      ++seen[body.name];
      const double up = std::abs(body.world_from_body.linear()(2, 2));
      ++things;
      askew += up > 0.05 && up < 0.95;
      EXPECT_LT(body.world_from_body.translation().head<2>().norm(), 0.25);
    }
    EXPECT_LE(shapeless, 2);
  }
  for (const char* name : {"sphere", "cylinder", "cup", "bowl", "cone", "pot", "box"}) EXPECT_GE(seen[name], 5) << name;
  EXPECT_GT(askew, 0.4 * things);
  EXPECT_LT(askew, 0.75 * things);
}

/// Whether, moved down by this (m), a point of the body would be in the table or another one.
bool touches(const World& world, std::size_t index, double down) {
  Random random(7);
  for (const Vec3& p : pointsInside(world.bodies()[index], 4000, random)) {
    const Vec3 moved = p - down * Vec3::UnitZ();
    for (std::size_t other = 1; other < world.bodies().size(); ++other) {
      if (other != index && contains(world.bodies()[other], moved)) return true;
    }
  }
  return false;
}

TEST(Heap, EverythingLiesOnSomething) {
  constexpr double kDown = 0.02;  // m: of a corner, few random points are nearer
  for (const World& world : worlds()) {
    for (std::size_t i = kFirst; i < world.bodies().size(); ++i) {
      EXPECT_TRUE(touches(world, i, kDown)) << world.bodies()[i].name << " hangs in the air";
    }
  }
}

TEST(Heap, NothingSinksInMuch) {
  for (const World& world : worlds()) {
    Random random(8);
    for (std::size_t i = kFirst; i < world.bodies().size(); ++i) {
      for (const Vec3& p : pointsInside(world.bodies()[i], 200, random)) {
        EXPECT_GT(p.z(), kTableHeight - kSunken);
        for (std::size_t before = kFirst; before < i; ++before) {
          // A point sunk in is outside again a little higher.
          EXPECT_FALSE(contains(world.bodies()[before], p) &&
                       contains(world.bodies()[before], p + kSunken * Vec3::UnitZ()))
              << world.bodies()[i].name << " in " << world.bodies()[before].name;
        }
      }
    }
  }
}

TEST(Heap, ThingsLieUponOneAnother) {
  int raised = 0, things = 0;
  for (const World& world : worlds()) {
    for (std::size_t i = kFirst; i < world.bodies().size(); ++i) {
      // Bodies whose lowest point the tests know in any pose.
      const Body& body = world.bodies()[i];
      if (std::holds_alternative<Bowl>(body.solid) || std::holds_alternative<Lump>(body.solid)) continue;
      ++things;
      raised += lowestPoint(body) > kTableHeight + 0.01;
    }
  }
  EXPECT_GT(raised, 0.25 * things);
}

TEST(Heap, IsTheSameForTheSameSeedOnly) {
  const World again = heap(1);
  const World& first = worlds()[0];
  ASSERT_EQ(again.bodies().size(), first.bodies().size());
  for (std::size_t i = 0; i < again.bodies().size(); ++i) {
    EXPECT_TRUE(again.bodies()[i].world_from_body.isApprox(first.bodies()[i].world_from_body, 0.0));
  }
  const World& other = worlds()[1];
  EXPECT_FALSE(other.bodies()[kFirst].world_from_body.isApprox(first.bodies()[kFirst].world_from_body, 1e-6));
}

}  // namespace
}  // namespace primitect::synthetic::heap_test
