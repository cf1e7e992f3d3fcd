// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tops of one height out of a plane that leads over several.
#include "core/level_top.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "core/random.h"
#include "test/support/exact_shapes.h"

namespace primitect {
namespace {

constexpr double kSigma = 0.002;  // m
const Vec3 kUp = -Vec3::UnitZ();

/// Tops on a table 1 m below the sensor, one after the other.
class Tops {
 public:
  /// Of 10 x 10 cm from x on (m), at a height above the table, with a slope in x. Returns how many points there are
  /// now.
  std::size_t add(double x, double height, int points_per_side, double slope = 0.0) {
    for (int row = 0; row < points_per_side; ++row) {
      for (int column = 0; column < points_per_side; ++column) {
        const double dx = 0.1 * column / points_per_side, dy = 0.1 * row / points_per_side;
        const double z = 1.0 - height - slope * (x + dx) + kSigma * random_.gaussian();
        points_.push_back({Vec3(x + dx, dy, z), kUp});
      }
    }
    return points_.size();
  }

  /// Points left of a plane through two places at these heights.
  List<std::uint32_t> under(double x, double height, double other_x, double other_height) const {
    const double tilt = (other_height - height) / (other_x - x);
    const Plane plane = {Vec3(x, 0.0, 1.0 - height), Vec3(-tilt, 0.0, -1.0).normalized()};
    const Cloud cloud = test::cloudOf(points_);
    List<std::uint32_t> all(cloud.size());
    std::iota(all.begin(), all.end(), 0u);
    return levelTop(
        cloud, plane, kUp, [](const Vec3&) { return kSigma; }, all);
  }

 private:
  std::vector<test::SurfacePoint> points_;
  Random random_{1};
};

TEST(LevelTop, IsTheLargerOneWhereAPlaneLeadsOverTwo) {
  Tops tops;
  const std::size_t first = tops.add(0.0, 0.0, 30);
  tops.add(0.4, 0.008, 20);
  const List<std::uint32_t> left = tops.under(0.05, 0.0, 0.45, 0.008);
  ASSERT_EQ(left.size(), first);
  EXPECT_EQ(left.front(), 0u);
  EXPECT_EQ(left.back(), first - 1);
}

TEST(LevelTop, IsTheLevelOneBesideALargerPieceOfClutter) {
  Tops tops;
  const std::size_t clutter = tops.add(0.0, -0.02, 30, 0.2);
  const std::size_t all = tops.add(0.4, 0.008, 27);
  const List<std::uint32_t> left = tops.under(0.05, -0.01, 0.45, 0.008);
  ASSERT_EQ(left.size(), all - clutter);
  EXPECT_EQ(left.front(), clutter);
}

TEST(LevelTop, HoldsAllPiecesOfOneHeight) {
  Tops tops;
  tops.add(0.0, 0.0, 30);
  const std::size_t two = tops.add(0.4, 0.0, 20);
  tops.add(0.8, 0.008, 20);
  EXPECT_EQ(tops.under(0.05, 0.0, 0.85, 0.008).size(), two);
}

TEST(LevelTop, IsAllOfAPlaneThatReallyIsTilted) {
  constexpr double kTilt = 0.05;
  Tops tops;
  tops.add(0.0, 0.0, 30, kTilt);
  const std::size_t all = tops.add(0.4, 0.0, 20, kTilt);
  EXPECT_EQ(tops.under(0.0, 0.0, 0.4, 0.4 * kTilt).size(), all);
}

TEST(LevelTop, IsAllOfAFaceTooSteepForATop) {
  for (const double slope : {0.08, 0.12}) {
    Tops tops;
    tops.add(0.0, 0.0, 30);
    const std::size_t all = tops.add(0.4, 0.4 * slope, 20);
    const std::size_t left = tops.under(0.05, 0.0, 0.45, 0.4 * slope).size();
    EXPECT_EQ(left == all, slope > 0.1) << slope;
  }
}

TEST(LevelTop, IsAllOfASinglePieceHoweverItLies) {
  Tops tops;
  const std::size_t all = tops.add(0.0, 0.0, 30);
  EXPECT_EQ(tops.under(0.0, 0.0, 0.1, 0.01).size(), all);
}

TEST(LevelTop, OfNothingIsNothing) { EXPECT_TRUE(Tops().under(0.0, 0.0, 0.1, 0.01).empty()); }

}  // namespace
}  // namespace primitect
