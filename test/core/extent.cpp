// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The part of a shape that was seen.
#include "core/extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect::extent_test {
namespace {

using test::patchOf;
using test::pointOn;
using test::SurfacePoint;

std::vector<Vec3> pointsOf(const std::vector<SurfacePoint>& points) {
  std::vector<Vec3> result;
  for (const SurfacePoint& p : points) result.push_back(p.point);
  return result;
}

Extent toTheEnds(const Shape& shape, const std::vector<Vec3>& points) {
  Extent extent;
  measureToTheEnds(shape, points, extent);
  return extent;
}

// Float holds 1 m to 1e-7.
constexpr double kRounding = 2e-7;

TEST(Extent, OfARectangleIsItsOutlineSeenFromTheSensor) {
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  std::vector<Vec3> points;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) points.push_back({0.1 + 0.06 * i, 0.2 + 0.02 * j, 1.0});
  }
  const Extent extent = measureExtent(plane, points);
  EXPECT_LT((extent.origin - Vec3(0.4, 0.3, 1.0)).norm(), kRounding);
  EXPECT_NEAR(extent.size.x(), 0.6, kRounding);
  EXPECT_NEAR(extent.size.y(), 0.2, kRounding);
  EXPECT_LT((extent.rotation.col(2) - plane.normal).norm(), 1e-12);
  EXPECT_NEAR(extent.rotation.determinant(), 1.0, 1e-12);
  ASSERT_EQ(extent.hull.size(), 4u);
  double area = 0.0;
  for (std::size_t k = 0; k < 4; ++k) area += 0.5 * extent.hull[k].cross(extent.hull[(k + 1) % 4]).dot(plane.normal);
  EXPECT_NEAR(area, 0.12, kRounding);  // positive: counter-clockwise around the normal
}

TEST(Extent, OfASquareIsAsWideAsItIsWhereverThePointsLie) {
  // The largest spread of the points of a square may be along its diagonal.
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const Plane plane = {Vec3(0, 0, 1), Vec3(0.2, -0.1, -1).normalized()};
    const Vec3 across = plane.normal.unitOrthogonal(), down = plane.normal.cross(across);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 2000; ++i) {
      const double u = random.uniform(-0.05, 0.05), v = random.uniform(-0.05, 0.05);
      points.push_back({plane.point + (u + 0.1) * across + v * down, plane.normal});
    }
    const Extent extent = measureExtent(plane, pointsOf(points));
    EXPECT_NEAR(extent.size.x(), 0.1, 0.003);
    EXPECT_NEAR(extent.size.y(), 0.1, 0.003);
    EXPECT_LE(extent.size.y(), extent.size.x());
    EXPECT_LT((extent.origin - plane.point - 0.1 * across).norm(), 0.002);
    EXPECT_GE(extent.rotation(0, 0), 0.0);
  }
}

TEST(Extent, OfPointsInOnePlaceIsThatPlace) {
  const Vec3 place(0.1, 0.2, 1.0);
  const Extent extent = measureExtent(Plane{place, -Vec3::UnitZ()}, std::vector<Vec3>(100, place));
  EXPECT_LT((extent.origin - place).norm(), 1e-6);
  EXPECT_EQ(extent.size.head<2>().norm(), 0.0);
  EXPECT_TRUE(extent.hull.empty());
}

TEST(Extent, OfACylinderLiesBetweenItsSeenEnds) {
  Random random(35);
  const Cylinder cylinder = {Vec3(0.1, 0.2, 1.0), Vec3(0, -1, 0), 0.05};
  const Extent extent = measureExtent(cylinder, pointsOf(patchOf(cylinder, 3000, 0.02, 0.14, random)));
  EXPECT_NEAR(extent.size.z(), 0.12, 0.005);  // 1 % of stragglers at either end
  EXPECT_LT((extent.origin - Vec3(0.1, 0.12, 1.0)).norm(), 0.003);
  EXPECT_EQ(extent.radius, 0.05);
  EXPECT_LT((extent.rotation.col(2) - cylinder.axis).norm(), 1e-12);
  EXPECT_LT(extent.rotation.col(0).dot(cylinder.point), 0.0);  // x towards the side that was seen
}

TEST(Extent, OfAConeHasTheRadiiOfItsSeenEnds) {
  Random random(36);
  const Cone cone = {Vec3(0, -0.1, 1.0), Vec3(0, 1, 0), std::atan(0.5)};
  const Extent extent = measureExtent(cone, pointsOf(patchOf(cone, 3000, 0.05, 0.25, random)));
  EXPECT_NEAR(extent.radius, 0.125, 0.003);
  EXPECT_NEAR(extent.radius_small, 0.025, 0.003);
  EXPECT_NEAR(extent.size.z(), 0.2, 0.008);
}

/// A hundredth of the points of a cone covers a tenth of its length there.
TEST(Extent, OfAConeGoesToItsTip) {
  constexpr int kTimes = 10;
  double tips = 0.0;
  for (std::uint64_t seed = 1; seed <= kTimes; ++seed) {
    Random random(seed);
    const Cone cone = {Vec3(0, -0.1, 1.0), Vec3(0, 1, 0), std::atan(0.5)};
    std::vector<Vec3> points;
    for (int k = 0; k < 2000; ++k) {
      const double height = 0.2 * std::sqrt(random.uniform(0.0, 1.0)), angle = random.uniform(0.0, M_PI);
      const double radius = 0.5 * height;
      points.push_back(cone.apex + Vec3(radius * std::cos(angle), height, -radius * std::sin(angle)));
    }
    const Extent extent = toTheEnds(cone, points);
    tips += extent.radius_small / kTimes;
    EXPECT_NEAR(extent.radius, 0.1, 0.001);
  }
  EXPECT_LT(tips, 0.04 * 0.1);
}

/// The tip is one point of thousands: found whichever place it has among them.
TEST(Extent, OfAConeOfManyPointsGoesToItsTipWhicheverWayItPoints) {
  Random random(45);
  const Cone cone = {Vec3(0, -0.1, 1.0), Vec3(0, 1, 0), std::atan(0.5)};
  std::vector<Vec3> points;
  for (int row = 0; row < 100; ++row) {  // of an image, the widest first
    const double height = 0.2 - 0.002 * row;
    for (int k = 0; k < 100 - row; ++k) points.push_back(pointOn(cone, height, random.uniform(0.0, M_PI)).point);
  }
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_LT(toTheEnds(cone, points).radius_small, 0.5 * 0.0021) << turn;
    std::reverse(points.begin(), points.end());
  }
}

/// Of a stump (m, heights from the apex) with so many points, and so many stragglers between its top and the apex.
int timesStretched(double top, int count, int stragglers) {
  const Cone cone = {Vec3(0, -0.1, 1.0), Vec3(0, 1, 0), std::atan(0.5)};
  int stretched = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<Vec3> points;
    for (int k = 0; k < stragglers; ++k) points.push_back(pointOn(cone, 0.004 + 0.001 * k, 0.3).point);
    while (static_cast<int>(points.size()) < count) {
      const double height = 0.2 * std::sqrt(random.uniform(0.0, 1.0));
      if (height > top) points.push_back(pointOn(cone, height, random.uniform(0.0, M_PI)).point);
    }
    stretched += toTheEnds(cone, points).radius_small < 0.25 * top ? 1 : 0;
  }
  return stretched;
}

TEST(Extent, OfAStumpIsHardlyEverStretchedByStragglers) {
  for (const int count : {300, 2000}) {
    EXPECT_LE(timesStretched(0.028, count, 1), 2) << "as far as the number of points tells, it may be a tip";
  }
  EXPECT_EQ(timesStretched(0.08, 2000, 3), 0) << "it is none";
}

TEST(Extent, OfFewPointsGoesToTheEnds) {
  for (const int count : {20, 60, 99}) {
    Random random(44);
    const Cylinder cylinder = {Vec3(0.1, 0.2, 1.0), Vec3(0, -1, 0), 0.05};
    const Extent extent = toTheEnds(cylinder, pointsOf(patchOf(cylinder, count, 0.02, 0.14, random)));
    EXPECT_NEAR(extent.size.z(), 0.12, 3.0 * 0.12 / count) << "a hundredth of so few is none";
  }
}

TEST(Extent, OfACylinderGoesToItsEnds) {
  Random random(43);
  const Cylinder cylinder = {Vec3(0.1, 0.2, 1.0), Vec3(0, -1, 0), 0.05};
  const Extent extent = toTheEnds(cylinder, pointsOf(patchOf(cylinder, 3000, 0.02, 0.14, random)));
  EXPECT_NEAR(extent.size.z(), 0.12, 0.001);  // 1 % of the points to a third, at either end
  EXPECT_LT((extent.origin - Vec3(0.1, 0.12, 1.0)).norm(), 0.001);
}

/// A hundredth of the points may be anything's.
TEST(Extent, ToTheEndsIsHardlyStretchedByStragglers) {
  Random random(42);
  const Cylinder cylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
  std::vector<Vec3> points = pointsOf(patchOf(cylinder, 1000, -0.05, 0.05, random));
  for (int k = 0; k < 9; ++k) points.push_back(pointOn(cylinder, 1.0 + 0.1 * k, 0.0).point);
  EXPECT_LT(toTheEnds(cylinder, points).size.z(), 0.103);
}

TEST(Extent, IsNotStretchedByAStraggler) {
  Random random(37);
  const Cylinder cylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
  std::vector<Vec3> points = pointsOf(patchOf(cylinder, 300, -0.05, 0.05, random));
  points.push_back(pointOn(cylinder, 3.0, 0.0).point);
  EXPECT_LT(measureExtent(cylinder, points).size.z(), 0.101);
}

TEST(Extent, OfAPlaneLeavesOutWhatLiesElsewhereInIt) {
  Random random(39);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  std::vector<Vec3> points = pointsOf(patchOf(plane, 80, 0.08, random));
  points.push_back(Vec3(0.45, 0.1, 1.0));
  points.push_back(Vec3(0.46, 0.1, 1.0));
  const Extent extent = measureExtent(plane, points);
  EXPECT_LT(extent.size.head<2>().norm(), 0.16 * 1.5);
  for (const Vec3& corner : extent.hull) EXPECT_LT(corner.norm(), 1.1);
}

TEST(Extent, OfAPlaneGoesAroundLargePartsThatSomethingInFrontSeparates) {
  Random random(40);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  std::vector<Vec3> points = pointsOf(patchOf(plane, 200, 0.05, random));
  for (const Vec3& point : pointsOf(patchOf(plane, 100, 0.04, random))) points.push_back(point + Vec3(0.3, 0, 0));
  // From -0.05 to 0.34 m, less what no point happens to lie near.
  EXPECT_NEAR(measureExtent(plane, points).size.x(), 0.39, 0.02);
}

TEST(Extent, OfAPlaneHoldsPartsOfAFifthOfTheLargestOrMore) {
  Random random(41);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  // As dense as the first part; from -0.05 to 0.05 m, and around 0.3 m.
  for (const auto& [count, half_width, width] : {std::tuple(60, 0.027, 0.377), std::tuple(24, 0.017, 0.1)}) {
    std::vector<Vec3> points = pointsOf(patchOf(plane, 200, 0.05, random));
    for (const Vec3& point : pointsOf(patchOf(plane, count, half_width, random))) {
      points.push_back(point + Vec3(0.3, 0, 0));
    }
    EXPECT_NEAR(measureExtent(plane, points).size.x(), width, 0.02) << count;
  }
}

/// Beside a post, an eighth of a wall; and as few points in a strip along it.
TEST(Extent, OfAPlaneHoldsAnEighthThatIsNoStrip) {
  Random random(46);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  for (const auto& [half_width, half_height, width] :
       {std::tuple(0.09, 0.09, 0.79), std::tuple(0.01, 0.25, 0.5), std::tuple(0.05, 0.05, 0.5)}) {
    std::vector<Vec3> points = pointsOf(patchOf(plane, 2000, 0.25, random));
    const int count = static_cast<int>(std::lround(2000 * half_width * half_height / (0.25 * 0.25)));
    for (int k = 0; k < count; ++k) {
      const double across = random.uniform(-half_width, half_width), up = random.uniform(-half_height, half_height);
      points.emplace_back(0.45 + across, up, 1.0);
    }
    EXPECT_NEAR(measureExtent(plane, points).size.x(), width, 0.02) << half_width;
  }
}

/// As of a wall above and below a table, where the closer look drew from the part below.
TEST(Extent, OfAPlaneHoldsLargePartsThatFewSamplesSaw) {
  Random random(42);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  for (const auto& [count, width] : {std::pair(250, 0.75), std::pair(60, 0.1)}) {
    std::vector<Vec3> points = pointsOf(patchOf(plane, 2000, 0.05, random));
    for (const Vec3& point : pointsOf(patchOf(plane, count, 0.15, random))) points.push_back(point + Vec3(0.55, 0, 0));
    EXPECT_NEAR(measureExtent(plane, points).size.x(), width, 0.03) << count;
  }
}

TEST(Extent, OfAPlaneHoldsTheOutermostButNotWhatLiesApart) {
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  std::vector<Vec3> points;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) points.push_back({0.01 * i, 0.01 * j, 1.0});
  }
  const Vec3 apart(0.25, 0.05, 1.0), middle(0.05, 0.05, 1.0);
  for (const Vec3& side : {Vec3(-0.07, 0, 0), Vec3(0.07, 0, 0), Vec3(0, -0.07, 0), Vec3(0, 0.07, 0)}) {
    const Extent extent = measureExtent(plane, points, std::vector<Vec3>{middle + side, apart}, {});
    EXPECT_NEAR(extent.size.x(), 0.12, 1e-6) << side.transpose();
    EXPECT_NEAR(extent.size.y(), 0.1, 1e-6) << side.transpose();
    EXPECT_LT((extent.origin - middle - side / 7.0).norm(), 1e-6) << side.transpose();
  }
}

TEST(Extent, OfPointsInOnePlaceIsNotStretchedByOthers) {
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  const std::vector<Vec3> one(5, Vec3(0.1, 0.1, 1.0));
  const Extent extent = measureExtent(plane, one, std::vector<Vec3>{{5.0, 0.1, 1.0}, {-3.0, 2.0, 1.0}}, {});
  EXPECT_NEAR(extent.size.norm(), 0.0, 1e-6);
}

TEST(Extent, OfAThinStripIsTheWholeStrip) {
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  std::vector<Vec3> points;
  for (int i = 0; i <= 100; ++i) points.push_back({0.01 * i, 0.0, 1.0});
  EXPECT_NEAR(measureExtent(plane, points).size.x(), 1.0, kRounding);
}

TEST(Canonical, CylinderAxesPointUpInTheImage) {
  for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0.9, 0.1, 0.3)}) {
    EXPECT_LT(std::get<Cylinder>(canonical(Cylinder{Vec3::Zero(), axis.normalized(), 1.0})).axis.y(), 0.0);
  }
  // What lies points to the right, whichever end noise makes the higher one.
  for (const double higher : {0.0, 0.05, -0.05}) {
    const Vec3 axis = Vec3(-1.0, higher, 0.3).normalized();
    EXPECT_GT(std::get<Cylinder>(canonical(Cylinder{Vec3::Zero(), axis, 1.0})).axis.x(), 0.0) << higher;
  }
  EXPECT_GT(std::get<Cylinder>(canonical(Cylinder{Vec3::Zero(), -Vec3::UnitZ(), 1.0})).axis.z(), 0.0);
}

}  // namespace
}  // namespace primitect::extent_test
