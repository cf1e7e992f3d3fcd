// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Strips that are flat, and such that are the side of a tube.
#include "core/bent_strip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/extent.h"
#include "core/random.h"

namespace primitect {
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

/// As it comes from the fit to these points: in their middle.
std::optional<Cylinder> tubeOf(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  const Plane plane = {mean, kPlane.normal};
  return tubeOf(plane, measureExtent(plane, points), points);
}

TEST(BentStrip, IsTheSideOfATube) {
  constexpr double kRadius = 0.015;
  const std::optional<Cylinder> tube = tubeOf(strip(0.02, 0.2, kRadius, kNoise));
  ASSERT_TRUE(tube);
  EXPECT_NEAR(tube->radius, kRadius, 0.2 * kRadius);
  EXPECT_GT(std::abs(tube->axis.y()), 0.999);
  EXPECT_NEAR(tube->point.z(), 1.0 + kRadius, 0.2 * kRadius);
  EXPECT_NEAR(tube->point.x(), 0.1, 0.001);
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
  std::vector<Vec3> exact, two_lines;
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 5; ++j) exact.push_back({0.1 + 0.005 * j, 0.01 * i, 1.0});
    for (int j = 0; j < 2; ++j) two_lines.push_back({0.1 + 0.02 * j, 0.01 * i, 1.0});
  }
  EXPECT_EQ(trustInFlat(kPlane, measureExtent(kPlane, exact), exact), 1.0);
  EXPECT_EQ(trustInFlat(kPlane, measureExtent(kPlane, two_lines), two_lines), 1.0);
}

TEST(BentStrip, IsNoneThatIsFlatHollowOrWide) {
  const double flat = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(tubeOf(strip(0.02, 0.2, flat, kNoise)));
  EXPECT_FALSE(tubeOf(strip(0.002, 0.2, flat, kNoise)));  // noise may turn it, but is known to
  EXPECT_FALSE(tubeOf(strip(0.02, 0.2, -0.015, kNoise)));
  EXPECT_FALSE(tubeOf(strip(0.02, 0.2, 0.025, kNoise)));  // 45 deg of it
  EXPECT_FALSE(tubeOf(strip(0.02, 0.03, 0.015, kNoise)));
  EXPECT_FALSE(tubeOf(std::vector<Vec3>()));
  EXPECT_FALSE(tubeOf(std::vector<Vec3>(10, Vec3(0, 0, 1))));
}

}  // namespace
}  // namespace primitect
