// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tubes that go on as a line of a few points.
#include "core/thin_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "test/support/tube_points.h"

namespace primitect::thin_ends_test {
namespace {

const Cylinder kTube = {Vec3(0.1, 0.2, 1.0), Vec3(0.6, 0.0, 0.8), 0.03};

/// What is seen of it.
SeenPoints seen(std::initializer_list<test::TubePart> parts, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (const test::SurfacePoint& p : test::tubeOf(kTube, parts, random)) points.push_back(p.point);
  return points;
}

/// All of it is left.
bool staysWhole(const SeenPoints& points) { return withoutThinEnds(kTube, points).size() == points.size(); }

/// Lowest and highest point along the axis (m).
std::pair<double, double> rangeOf(const SeenPoints& points) {
  double low = 1e9, high = -1e9;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double height = (points.point(k) - kTube.point).dot(kTube.axis);
    low = std::min(low, height), high = std::max(high, height);
  }
  return {low, high};
}

TEST(ThinEnds, AreLeftOut) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SeenPoints left = withoutThinEnds(kTube, seen({{1200, 0.0, 0.12}, {800, -0.2, 1.0, true}}, seed));
    const auto [low, high] = rangeOf(left);
    EXPECT_NEAR(low, 0.0, 0.004) << seed;
    EXPECT_NEAR(high, 0.12, 0.004) << seed;
    EXPECT_GE(left.size(), 1200u) << seed;
  }
}

TEST(ThinEnds, AreNoneWhereATubeIsSeenAllAlong) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_TRUE(staysWhole(seen({{2000, 0.0, 0.2}}, seed))) << seed;
    const std::initializer_list<test::TubePart> uneven = {
        {400, 0.0, 0.1}, {370, 0.1, 0.2}, {340, 0.2, 0.3}, {310, 0.3, 0.4}, {280, 0.4, 0.5},
        {250, 0.5, 0.6}, {220, 0.6, 0.7}, {190, 0.7, 0.8}, {160, 0.8, 0.9}, {130, 0.9, 1.0}};
    EXPECT_TRUE(staysWhole(seen(uneven, seed))) << seed << ", a third as dense at one end";
  }
}

TEST(ThinEnds, AreNoGapsBetween) { EXPECT_TRUE(staysWhole(seen({{500, 0.0, 0.1}, {500, 0.3, 0.4}}, 11))); }

TEST(ThinEnds, AreNotLookedForAmongFewPoints) {
  EXPECT_TRUE(staysWhole(seen({{60, 0.0, 0.1}, {3, 0.5, 0.6}}, 12)));
  EXPECT_TRUE(staysWhole(std::vector<Vec3>(100, kTube.point))) << "in one place";
  EXPECT_TRUE(withoutThinEnds(kTube, {}).empty());
}

}  // namespace
}  // namespace primitect::thin_ends_test
