// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What lies on the part of a shape that was seen, and what elsewhere on it.
#include "core/observed_part.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/extent.h"
#include "test/support/exact_shapes.h"

namespace primitect::observed_part_test {
namespace {

constexpr float kMargin = 0.005f;

bool holds(const ObservedPart& part, const Vec3& p, float margin = kMargin) {
  const Eigen::Vector3f f = p.cast<float>();
  return part.holds(f.x(), f.y(), f.z(), margin);
}

/// A rectangle of 0.6 x 0.2 m.
const Plane kPlane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
ObservedPart rectangle() {
  std::vector<Vec3> points;
  for (int i = 0; i <= 30; ++i) {
    for (int j = 0; j <= 10; ++j) points.push_back({-0.3 + 0.02 * i, -0.1 + 0.02 * j, 1.0});
  }
  return ObservedPart(kPlane, measureExtent(kPlane, points));
}

const Cylinder kCylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
ObservedPart between(double low, double high) {
  Extent extent;
  extent.rotation.col(2) = kCylinder.axis;
  extent.origin = kCylinder.point + 0.5 * (low + high) * kCylinder.axis;
  extent.size.z() = high - low;
  return ObservedPart(kCylinder, extent);
}

TEST(ObservedPart, OfAPlaneEndsAtItsOutlineAndTheMargin) {
  const ObservedPart part = rectangle();
  for (const double x : {-0.304, -0.29, 0.0, 0.2, 0.304}) {
    for (const double y : {-0.104, 0.0, 0.104}) EXPECT_TRUE(holds(part, Vec3(x, y, 1))) << x << " " << y;
  }
  for (const auto& [x, y] :
       {std::pair(0.306, 0.0), std::pair(-0.306, 0.0), std::pair(0.0, 0.106), std::pair(0.2, -0.106)}) {
    EXPECT_FALSE(holds(part, Vec3(x, y, 1))) << x << " " << y;
  }
}

TEST(ObservedPart, OfAnAxisLiesBetweenItsEnds) {
  const ObservedPart part = between(-0.05, 0.07);
  for (const double angle : {0.0, 1.0, 4.0}) {
    EXPECT_TRUE(holds(part, test::pointOn(kCylinder, 0.074, angle).point));
    EXPECT_FALSE(holds(part, test::pointOn(kCylinder, 0.076, angle).point));
    EXPECT_TRUE(holds(part, test::pointOn(kCylinder, -0.054, angle).point));
    EXPECT_FALSE(holds(part, test::pointOn(kCylinder, -0.056, angle).point));
  }
}

TEST(ObservedPart, OfASphereIsAllOfIt) {
  const Sphere sphere = {Vec3(0, 0, 1), 0.1};
  const ObservedPart part(sphere, measureExtent(sphere, std::vector<Vec3>{Vec3(0, 0, 0.9)}));
  EXPECT_TRUE(holds(part, Vec3(0, 0, 1.1), 0.0f));
  EXPECT_EQ(part.depth(0, 0, 1.1f), std::numeric_limits<float>::infinity());
}

TEST(ObservedPart, KnowsHowDeepAPointLies) {
  EXPECT_NEAR(rectangle().depth(0.25f, 0.02f, 1.0f), 0.05, 1e-6);  // float holds 1 m to 1e-7
  EXPECT_NEAR(rectangle().depth(0.0f, 0.2f, 1.0f), -0.1, 1e-6);
  EXPECT_NEAR(between(-0.05, 0.07).depth(0.0f, 0.0f, 0.95f), 0.05, 1e-6);
}

}  // namespace
}  // namespace primitect::observed_part_test
