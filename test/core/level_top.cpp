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

namespace primitect::level_top_test {
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

  /// The tops that a plane through two places at these heights is taken apart to.
  LevelTops under(double x, double height, double other_x, double other_height) const {
    const double tilt = (other_height - height) / (other_x - x);
    const Plane plane = {Vec3(x, 0.0, 1.0 - height), Vec3(-tilt, 0.0, -1.0).normalized()};
    const Cloud cloud = test::cloudOf(points_);
    List<std::uint32_t> all(cloud.size());
    std::iota(all.begin(), all.end(), 0u);
    return LevelTops(
        cloud, plane, kUp, [](const Vec3&) { return kSigma; }, all);
  }

  /// The top that the point is a part of.
  int topOf(std::size_t point, const LevelTops& tops) const { return tops.topAt(points_[point].point); }

 private:
  std::vector<test::SurfacePoint> points_;
  Random random_{1};
};

TEST(LevelTops, AreTwoWhereAPlaneLeadsOverTwoTheLargerOneFirst) {
  Tops things;
  const std::size_t first = things.add(0.0, 0.0, 20), all = things.add(0.4, 0.008, 30);
  const LevelTops tops = things.under(0.05, 0.0, 0.45, 0.008);
  ASSERT_EQ(tops.tops().size(), 2u);
  EXPECT_EQ(tops.tops()[0].count, all - first);
  EXPECT_EQ(tops.tops()[1].count, first);
  for (const std::size_t k : {0, 1}) {
    EXPECT_NEAR(tops.tops()[k].plane.point.z(), k == 0 ? 1.0 - 0.008 : 1.0, 5.0 * kSigma / 20.0);
    EXPECT_EQ(tops.tops()[k].plane.normal, kUp);
  }
  for (std::size_t i = 0; i < all; ++i) EXPECT_EQ(things.topOf(i, tops), i < first ? 1 : 0) << i;
}

TEST(LevelTops, AreToldApartByAMillimeterWhichIsHalfTheNoise) {
  Tops things;
  things.add(0.0, 0.0, 30);
  things.add(0.4, 0.001, 20);
  EXPECT_EQ(things.under(0.05, 0.0, 0.45, 0.001).tops().size(), 2u);
}

TEST(LevelTops, HoldPointsBetweenThoseThatWereGiven) {
  Tops things;
  things.add(0.0, 0.0, 30);
  things.add(0.4, 0.008, 20);
  const LevelTops tops = things.under(0.05, 0.0, 0.45, 0.008);
  EXPECT_EQ(tops.topAt({0.0513, 0.0502, 1.0}), 0);
  EXPECT_EQ(tops.topAt({0.4513, 0.0502, 0.992}), 1);
  EXPECT_EQ(tops.topAt({0.25, 0.05, 0.996}), LevelTops::kNone);
}

TEST(LevelTops, AreTheLevelOneBesideALargerPieceOfClutter) {
  Tops things;
  const std::size_t clutter = things.add(0.0, -0.02, 30, 0.2);
  const std::size_t all = things.add(0.4, 0.008, 27);
  const LevelTops tops = things.under(0.05, -0.01, 0.45, 0.008);
  ASSERT_EQ(tops.tops().size(), 1u);
  EXPECT_EQ(tops.tops()[0].count, all - clutter);
  EXPECT_EQ(things.topOf(0, tops), LevelTops::kNone);
}

TEST(LevelTops, AreNotOfThePartOfAClutteredSurfaceThatPassesThroughThePlane) {
  // As much as a plane takes from a slope that meets it: spread over what is allowed, not around one height.
  Tops things;
  const std::size_t first = things.add(0.0, 0.0, 30);
  things.add(0.4, 0.005, 20, 0.06);
  const LevelTops tops = things.under(0.05, 0.0, 0.45, 0.008);
  ASSERT_EQ(tops.tops().size(), 1u);
  EXPECT_EQ(tops.tops()[0].count, first);
}

TEST(LevelTops, HoldAllPiecesOfOneHeight) {
  Tops things;
  things.add(0.0, 0.0, 30);
  const std::size_t two = things.add(0.4, 0.0, 20);
  things.add(0.8, 0.008, 20);
  const LevelTops tops = things.under(0.05, 0.0, 0.85, 0.008);
  ASSERT_EQ(tops.tops().size(), 2u);
  EXPECT_EQ(tops.tops()[0].count, two);
}

TEST(LevelTops, AreNoneOfAPlaneThatReallyIsTilted) {
  constexpr double kTilt = 0.05;
  Tops things;
  things.add(0.0, 0.0, 30, kTilt);
  things.add(0.4, 0.0, 20, kTilt);
  EXPECT_TRUE(things.under(0.0, 0.0, 0.4, 0.4 * kTilt).tops().empty());
}

TEST(LevelTops, AreNoneOfAFaceTooSteepForATop) {
  for (const double slope : {0.08, 0.12}) {
    Tops things;
    things.add(0.0, 0.0, 30);
    things.add(0.4, 0.4 * slope, 20);
    EXPECT_EQ(things.under(0.05, 0.0, 0.45, 0.4 * slope).tops().empty(), slope > 0.1) << slope;
  }
}

TEST(LevelTops, AreNoneOfASinglePieceHoweverItLies) {
  Tops things;
  things.add(0.0, 0.0, 30);
  EXPECT_TRUE(things.under(0.0, 0.0, 0.1, 0.01).tops().empty());
}

TEST(LevelTops, AreNoneOfNothing) { EXPECT_TRUE(Tops().under(0.0, 0.0, 0.1, 0.01).tops().empty()); }

}  // namespace
}  // namespace primitect::level_top_test
