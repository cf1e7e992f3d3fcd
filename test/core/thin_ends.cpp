// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tubes that go on as a line of a few points.
#include "core/thin_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect {
namespace {

const Cylinder kTube = {Vec3(0.1, 0.2, 1.0), Vec3(0.6, 0.0, 0.8), 0.03};

/// So many points of the tube between these heights (m), on all of it or on one line.
void add(int count, double low, double high, bool on_line, Random& random, std::vector<Vec3>& points) {
  for (int i = 0; i < count; ++i) {
    const double height = random.uniform(low, high), angle = on_line ? 0.0 : random.uniform(0.0, 2.0 * M_PI);
    points.push_back(test::pointOn(kTube, height, angle).point);
  }
}

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
    Random random(seed);
    std::vector<Vec3> points;
    add(1200, 0.0, 0.12, false, random, points);
    add(800, -0.2, 1.0, true, random, points);
    const SeenPoints left = withoutThinEnds(kTube, points);
    const auto [low, high] = rangeOf(left);
    EXPECT_NEAR(low, 0.0, 0.004) << seed;
    EXPECT_NEAR(high, 0.12, 0.004) << seed;
    EXPECT_GE(left.size(), 1200u) << seed;
  }
}

TEST(ThinEnds, AreNoneWhereATubeIsSeenAllAlong) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<Vec3> even, uneven;
    add(2000, 0.0, 0.2, false, random, even);
    for (int part = 0; part < 10; ++part) add(400 - 30 * part, 0.1 * part, 0.1 * part + 0.1, false, random, uneven);
    EXPECT_EQ(withoutThinEnds(kTube, even).size(), even.size()) << seed;
    EXPECT_EQ(withoutThinEnds(kTube, uneven).size(), uneven.size()) << seed << ", a third as dense at one end";
  }
}

TEST(ThinEnds, AreNoGapsBetween) {
  Random random(11);
  std::vector<Vec3> points;
  add(500, 0.0, 0.1, false, random, points);
  add(500, 0.3, 0.4, false, random, points);
  EXPECT_EQ(withoutThinEnds(kTube, points).size(), points.size());
}

TEST(ThinEnds, AreNotLookedForAmongFewPoints) {
  Random random(12);
  std::vector<Vec3> points;
  add(60, 0.0, 0.1, false, random, points);
  add(3, 0.5, 0.6, false, random, points);
  EXPECT_EQ(withoutThinEnds(kTube, points).size(), points.size());
  const std::vector<Vec3> in_one_place(100, kTube.point);
  EXPECT_EQ(withoutThinEnds(kTube, in_one_place).size(), in_one_place.size());
  EXPECT_TRUE(withoutThinEnds(kTube, {}).empty());
}

}  // namespace
}  // namespace primitect
