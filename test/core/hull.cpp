// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Corners of hulls, and those that may be left out.
#include "core/hull.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "core/random.h"

namespace primitect::hull_test {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// How far a point lies outside of a polygon, counter-clockwise; negative inside.
double outside(const Vec2& p, const List<Vec2>& corners) {
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 side = corners[(k + 1) % corners.size()] - corners[k];
    most = std::max(most, -cross(side.normalized(), p - corners[k]));
  }
  return most;
}

/// The border of a rectangle, turned, all around: so many points on each side, as row ends of an image are.
List<Vec2> borderOf(double width, double height, double angle, int on_each) {
  const Eigen::Rotation2Dd turn(angle);
  List<Vec2> points;
  for (int k = 0; k < on_each; ++k) {
    const double at = static_cast<double>(k) / (on_each - 1);
    for (const Vec2& p :
         {Vec2(at * width, 0.0), Vec2(at * width, height), Vec2(0.0, at * height), Vec2(width, at * height)}) {
      points.push_back(turn * p);
    }
  }
  return points;
}

TEST(ConvexHull, OfExactBordersHasAllFourCornersWhereverTheyLie) {
  constexpr double kFlat = 1e-3;
  for (const double angle : {0.0, 0.1, 0.5, 0.8, 1.3, 2.0, 3.0}) {
    for (const int on_each : {2, 40, 2000}) {
      const List<Vec2> points = borderOf(1.0, 0.6, angle, on_each);
      const List<Vec2> hull = convexHull(points, kFlat);
      EXPECT_EQ(hull.size(), 4u) << angle << " " << on_each;
      double area = 0.0;
      for (std::size_t k = 0; k < hull.size(); ++k) area += 0.5 * cross(hull[k], hull[(k + 1) % hull.size()]);
      EXPECT_NEAR(area, 0.6, 1e-3) << angle << " " << on_each;
    }
  }
}

TEST(ConvexHull, LeavesNoPointOutByMuchMoreThanWhatCountsAsFlat) {
  Random random(31);
  for (const double flat : {0.0, 0.002, 0.02}) {
    List<Vec2> points;
    // A disc, whose corners all stand out by little.
    for (int k = 0; k < 3000; ++k) {
      const double angle = random.uniform(-M_PI, M_PI), radius = std::sqrt(random.uniform(0.0, 1.0));
      points.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    const List<Vec2> hull = convexHull(points, flat);
    ASSERT_GE(hull.size(), 3u);
    // Once for what is left out between others, once for where the two halves meet.
    for (const Vec2& p : points) ASSERT_LT(outside(p, hull), 2.0 * flat + 1e-4) << flat;
  }
}

TEST(ConvexHull, OfPointsOnALineOrInOnePlaceIsNoPolygon) {
  EXPECT_LT(convexHull({Vec2(0, 0), Vec2(1, 1), Vec2(2, 2), Vec2(3, 3)}, 1e-3).size(), 3u);
  EXPECT_TRUE(convexHull({Vec2(1, 2), Vec2(1, 2), Vec2(1, 2)}, 1e-3).empty());
  EXPECT_TRUE(convexHull({}, 1e-3).empty());
}

}  // namespace
}  // namespace primitect::hull_test
