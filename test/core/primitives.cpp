// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Distance, normal and projection of the four shapes.
#include <gtest/gtest.h>

#include "test/support/exact_shapes.h"

namespace primitect::primitives_test {
namespace {

using test::pointOn;
using test::SurfacePoint;

struct Case {
  Shape shape;
  SurfacePoint on;
};

std::vector<Case> randomCases(int count) {
  Random random(11);
  std::vector<Case> cases;
  for (int i = 0; i < count; ++i) {
    const Plane plane = {test::randomPoint(random), test::randomDirection(random)};
    const Sphere sphere = {test::randomPoint(random), random.uniform(0.1, 1.0)};
    const Cylinder cylinder = {test::randomPoint(random), test::randomDirection(random), random.uniform(0.1, 1.0)};
    const Cone cone = {test::randomPoint(random), test::randomDirection(random), random.uniform(0.1, 1.3)};
    cases.push_back({plane, pointOn(plane, {random.uniform(), random.uniform()})});
    cases.push_back({sphere, pointOn(sphere, test::randomDirection(random))});
    cases.push_back({cylinder, pointOn(cylinder, {random.uniform(), random.uniform(0.0, 6.0)})});
    cases.push_back({cone, pointOn(cone, {random.uniform(0.3, 1.0), random.uniform(0.0, 6.0)})});
  }
  return cases;
}

TEST(Primitives, HaveTheKindOfTheirPlaceInTheVariant) {
  EXPECT_EQ(kindOf(Plane{}), Kind::plane);
  EXPECT_EQ(kindOf(Sphere{}), Kind::sphere);
  EXPECT_EQ(kindOf(Cylinder{}), Kind::cylinder);
  EXPECT_EQ(kindOf(Cone{}), Kind::cone);
  EXPECT_STREQ(kindName(Kind::cone), "cone");
}

TEST(Primitives, MeasureTheStepAlongTheNormal) {
  for (const Case& c : randomCases(100)) {
    // Up to 3 cm in or out: less than every radius, so the foot point stays the same.
    for (const double step : {-0.03, -0.01, 0.0, 0.01, 0.03, 0.5}) {
      EXPECT_NEAR(distance(c.shape, c.on.point + step * c.on.normal), step, 1e-12);
    }
  }
}

TEST(Primitives, HaveTheOutwardNormalOnBothSides) {
  for (const Case& c : randomCases(100)) {
    for (const double step : {-0.01, 0.02}) {
      EXPECT_LT((normalAt(c.shape, c.on.point + step * c.on.normal) - c.on.normal).norm(), 1e-9);
    }
  }
}

TEST(Primitives, ProjectBackOntoTheFootPoint) {
  for (const Case& c : randomCases(100)) {
    EXPECT_LT((project(c.shape, c.on.point + 0.02 * c.on.normal) - c.on.point).norm(), 1e-9);
  }
}

TEST(Cone, HasItsApexAsNearestPointBehindIt) {
  const Cone cone = {Vec3(1.0, 2.0, 3.0), Vec3::UnitX(), 0.4};
  EXPECT_DOUBLE_EQ(distance(cone, Vec3(0.0, 2.0, 3.0)), 1.0);
  EXPECT_LT((normalAt(cone, Vec3(0.0, 2.0, 3.0)) + Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((project(cone, Vec3(0.5, 2.1, 3.0)) - cone.apex).norm(), 1e-12);
}

TEST(Primitives, GiveFiniteUnitNormalsWhereTheNormalIsUndefined) {
  const Cylinder cylinder = {Vec3::Zero(), Vec3::UnitY(), 0.5};
  const Sphere sphere = {Vec3::Zero(), 0.5};
  const Cone cone = {Vec3::Zero(), Vec3::UnitY(), 0.5};
  EXPECT_NEAR(normalAt(cylinder, Vec3(0.0, 1.0, 0.0)).norm(), 1.0, 1e-12);
  EXPECT_NEAR(normalAt(sphere, Vec3::Zero()).norm(), 1.0, 1e-12);
  EXPECT_NEAR(normalAt(cone, Vec3::Zero()).norm(), 1.0, 1e-12);
  EXPECT_NEAR(normalAt(cone, Vec3(0.0, 1.0, 0.0)).norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace primitect::primitives_test
