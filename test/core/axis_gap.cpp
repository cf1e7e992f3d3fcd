// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points along an axis that lie apart from the others.
#include "core/axis_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

#include "test/support/tube_points.h"

namespace primitect::axis_gap_test {
namespace {

const Cylinder kTube = {Vec3(0.1, 0.2, 1.0), Vec3(0.6, 0.0, 0.8), 0.03};

/// How many are left of what is seen of it.
std::size_t leftOf(std::initializer_list<test::TubePart> parts, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (const test::SurfacePoint& p : test::tubeOf(kTube, parts, random)) points.push_back(p.point);
  return withoutFarEnds(kTube.axis, points).size();
}

TEST(FarEnds, AreLeftOutWhereTheyAreFew) {
  constexpr int kAtBorders = 4;  // of the sixteenths of the length: points that go with the others, or stay
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_NEAR(leftOf({{500, 0.0, 0.2}, {1, 0.4, 0.41}}, seed), 500, kAtBorders) << seed;
    EXPECT_NEAR(leftOf({{500, 0.0, 0.2}, {40, 0.335, 0.4}}, seed), 500, kAtBorders) << seed;
    EXPECT_NEAR(leftOf({{40, -0.35, -0.2}, {500, 0.0, 0.05}, {1, 0.25, 0.26}}, seed), 500, kAtBorders) << seed;
    // Some points in the gap do not join them: two in a sixteenth of the length at most.
    EXPECT_NEAR(leftOf({{1000, 0.0, 0.2}, {2, 0.2, 0.335}, {60, 0.335, 0.4}}, seed), 1000, kAtBorders) << seed;
  }
}

TEST(FarEnds, AreNoneWhereTheyAreManyOrNear) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(leftOf({{500, 0.0, 0.2}}, seed), 500u) << seed;
    EXPECT_EQ(leftOf({{500, 0.0, 0.2}, {80, 0.335, 0.4}}, seed), 580u) << seed << ", something is before its middle";
    EXPECT_EQ(leftOf({{500, 0.0, 0.2}, {40, 0.27, 0.35}}, seed), 540u) << seed << ", a fifth of the length apart";
    EXPECT_EQ(leftOf({{300, 0.0, 0.1}, {10, 0.2, 0.21}, {300, 0.3, 0.4}}, seed), 610u) << seed << ", is no end";
  }
}

TEST(FarEnds, AreFoundWhereFartherOnesHideThem) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_NEAR(leftOf({{500, 0.0, 0.2}, {20, 0.335, 0.36}, {1, 0.9, 0.91}}, seed), 500, 4) << seed;
  }
}

/// Of a pipe that leads away from the sensor to ten times as far few points are far away, but all are its own.
TEST(FarEnds, AreNoneWhereAPipeIsSeenEverLess) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<Vec3> points;
    for (int k = 0; k < 4000; ++k) {
      const double far = 1.0 / std::sqrt(random.uniform(0.01, 1.0));  // as 1 / r^3
      points.push_back(kTube.point + far * kTube.axis);
    }
    EXPECT_EQ(withoutFarEnds(kTube.axis, points).size(), 4000u) << seed;
  }
}

TEST(FarEnds, AreNoneOfAConeWhoseTipIsSeen) {
  const Cone cone = {Vec3(0, 0, 1), Vec3(0, 1, 0), 0.3};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<Vec3> points;
    for (const test::SurfacePoint& p : test::patchOf(cone, 300, 0.0, 0.2, random)) points.push_back(p.point);
    EXPECT_EQ(withoutFarEnds(cone.axis, points).size(), 300u) << seed;
  }
}

TEST(FarEnds, AreNotAskedForOfFewPointsOrInOnePlace) {
  EXPECT_EQ(leftOf({{60, 0.0, 0.2}, {1, 0.4, 0.41}}, 1), 61u);
  EXPECT_EQ(leftOf({}, 1), 0u);
  EXPECT_EQ(withoutFarEnds(Vec3::UnitX(), std::vector<Vec3>(100, Vec3(1, 2, 3))).size(), 100u);
}

}  // namespace
}  // namespace primitect::axis_gap_test
