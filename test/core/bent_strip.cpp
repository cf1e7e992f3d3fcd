// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Strips that are flat, and such that are the side of a tube.
#include "core/bent_strip.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "core/extent.h"
#include "core/random.h"

namespace primitect::bent_strip_test {
namespace {

constexpr double kNoise = 0.001;  // m
const Plane kPlane = {Vec3(0.1, 0.0, 1.0), -Vec3::UnitZ()};

/// Points along y of a strip around kPlane's point, as wide and as long as given, bent around a line behind it; a
/// negative radius: before it.
std::vector<Vec3> strip(double width, double length, double radius, double noise) {
  Random random(5);
  std::vector<Vec3> points;
  for (int k = 0; k < 1000; ++k) {
    const double x = width * random.uniform(-0.5, 0.5), y = length * random.uniform(-0.5, 0.5);
    const double sign = radius < 0.0 ? -1.0 : 1.0;
    const double behind = std::isinf(radius) ? 0.0 : sign * (std::abs(radius) - std::sqrt(radius * radius - x * x));
    points.push_back(kPlane.point + Vec3(x, y, behind + noise * random.gaussian()));
  }
  return points;
}

TEST(BentStrip, TurnsAsFarAsItsSidesAreApart) {
  const std::vector<Vec3> points = strip(0.01, 0.2, 0.02, 0.0);
  const Bend bend = bendAcross(kPlane, measureExtent(kPlane, points), points);
  EXPECT_NEAR(bend.turn, 0.5, 0.03);
  const std::vector<Vec3> hollow = strip(0.01, 0.2, -0.02, 0.0);
  EXPECT_NEAR(bendAcross(kPlane, measureExtent(kPlane, hollow), hollow).turn, -0.5, 0.03);
}

TEST(BentStrip, IsNoPlane) {
  const auto trust = [](double radius) {
    const std::vector<Vec3> points = strip(0.02, 0.2, radius, kNoise);
    return trustInFlat(kPlane, measureExtent(kPlane, points), points);
  };
  EXPECT_EQ(trust(0.015), 0.0);
  EXPECT_EQ(trust(-0.015), 0.0);
  EXPECT_EQ(trust(0.025), 0.0);  // nor enough of a tube
  EXPECT_EQ(trust(0.1), 1.0);
  EXPECT_EQ(trust(std::numeric_limits<double>::infinity()), 1.0);
  EXPECT_EQ(trustInFlat(kPlane, Extent(), std::vector<Vec3>()), 1.0);
}

/// What is no strip is left to the competition of kinds.
TEST(BentStrip, IsNoneThatIsWide) {
  const std::vector<Vec3> wide = strip(0.02, 0.03, 0.015, 0.0);
  EXPECT_GT(std::abs(bendAcross(kPlane, measureExtent(kPlane, wide), wide).turn), 0.6);
  EXPECT_EQ(trustInFlat(kPlane, measureExtent(kPlane, wide), wide), 1.0);
}

double trustIn(const std::vector<Vec3>& points) { return trustInFlat(kPlane, measureExtent(kPlane, points), points); }

TEST(BentStrip, IsNoneThatNoiseMayHaveBent) {
  // By as much as this one turns, but not by so many deviations; nor do a few points tell.
  const std::vector<Vec3> narrow = strip(0.002, 0.2, std::numeric_limits<double>::infinity(), 0.004);
  EXPECT_GT(std::abs(bendAcross(kPlane, measureExtent(kPlane, narrow), narrow).turn), 0.4);
  EXPECT_EQ(trustIn(narrow), 1.0);
  Random random(7);
  for (int draw = 0; draw < 500; ++draw) {
    std::vector<Vec3> few;
    for (int k = 0; k < 4 + draw % 10; ++k) {
      few.push_back(kPlane.point +
                    Vec3{random.uniform(-0.01, 0.01), random.uniform(-0.1, 0.1), 2.0 * kNoise * random.gaussian()});
    }
    EXPECT_EQ(trustIn(few), 1.0) << draw;
  }
}

/// Of other directions than the axes, so that sums are rounded.
TEST(BentStrip, IsNotToldFromTwoRowsOfPoints) {
  Random random(8);
  for (int draw = 0; draw < 500; ++draw) {
    const Plane plane = {Vec3{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1.0},
                         Vec3{random.gaussian(), random.gaussian(), -3.0}.normalized()};
    const Vec3 along = plane.normal.unitOrthogonal(), across = plane.normal.cross(along);
    std::vector<Vec3> exact, two_rows;
    for (int i = 0; i < 50; ++i) {
      for (int j = 0; j < 5; ++j) exact.push_back(plane.point + 0.01 * i * along + 0.005 * j * across);
      for (int j = 0; j < 2; ++j) two_rows.push_back(plane.point + 0.001 * i * along + 0.001 * j * across);
    }
    ASSERT_EQ(trustInFlat(plane, measureExtent(plane, exact), exact), 1.0) << draw;
    ASSERT_EQ(trustInFlat(plane, measureExtent(plane, two_rows), two_rows), 1.0) << draw;
  }
}

}  // namespace
}  // namespace primitect::bent_strip_test
