// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Features, conditions, weights and voting parameters of pairs, against exact geometry in random poses.
#include <gtest/gtest.h>

#include "test/support/exact_shapes.h"

namespace primitect::features_test {
namespace {

using kernels::OrientedPoint;
using kernels::PairFeatures;
using test::kDegree;
using test::pointOn;
using test::SurfacePoint;
using test::toKernel;

// Float features of points within 2 m: rounding of 1e-7 relative, amplified by 1 / (1 - C4) at 10 deg.
constexpr float kRounding = 2e-4f;

kernels::VotingRules tenDegrees() { return votingRules(presetParams("paper"), 1.0); }

PairFeatures featuresOf(const SurfacePoint& r, const SurfacePoint& i) { return pairFeatures(toKernel(r), toKernel(i)); }

/// A pair with given angles F2, F3 (in one plane with d) and F4 <= F2 + F3: features straight from eq. 2.
PairFeatures fromAngles(double length, double f2, double f3, double f4) {
  return {static_cast<float>(length * length), static_cast<float>(length * std::cos(f2)),
          static_cast<float>(length * std::cos(f3)), static_cast<float>(std::cos(f4))};
}

TEST(PairFeatures, AreTheCosinesOfThePointPairFeature) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const SurfacePoint r = {test::randomPoint(random), test::randomDirection(random)};
    const SurfacePoint i = {test::randomPoint(random), test::randomDirection(random)};
    const Vec3 d = i.point - r.point;
    const PairFeatures c = featuresOf(r, i);
    EXPECT_NEAR(c.c1, d.squaredNorm(), 1e-5);
    EXPECT_NEAR(c.c2, r.normal.dot(d), 1e-6);
    EXPECT_NEAR(c.c3, i.normal.dot(d), 1e-6);
    EXPECT_NEAR(c.c4, r.normal.dot(i.normal), 1e-6);
  }
}

TEST(Convexity, HoldsOnTheOutsideAndFailsOnTheInside) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Sphere sphere = {test::randomPoint(random), random.uniform(0.1, 1.0)};
    SurfacePoint a = pointOn(sphere, test::randomDirection(random));
    SurfacePoint b = pointOn(sphere, test::randomDirection(random));
    EXPECT_TRUE(isConvex(featuresOf(a, b)));
    a.normal = -a.normal;
    b.normal = -b.normal;
    EXPECT_FALSE(isConvex(featuresOf(a, b)));
  }
}

TEST(NormalsParallel, TurnsAtEpsilon) {
  const kernels::VotingRules rules = tenDegrees();
  EXPECT_TRUE(normalsParallel(fromAngles(1.0, 1.5, 1.5, 9.9 * kDegree), rules));
  EXPECT_FALSE(normalsParallel(fromAngles(1.0, 1.5, 1.5, 10.1 * kDegree), rules));
}

TEST(PointsCoplanar, AsksForBothAnglesToBeRight) {
  const kernels::VotingRules rules = tenDegrees();
  EXPECT_TRUE(pointsCoplanar(fromAngles(0.3, 99.9 * kDegree, 80.1 * kDegree, 0.0), rules));
  EXPECT_FALSE(pointsCoplanar(fromAngles(0.3, 100.1 * kDegree, 90.0 * kDegree, 0.0), rules));
  EXPECT_FALSE(pointsCoplanar(fromAngles(0.3, 90.0 * kDegree, 79.9 * kDegree, 0.0), rules));
}

TEST(AnglesSymmetric, TurnsWhereF2PlusF3LeavesPiByEpsilon) {
  const kernels::VotingRules rules = tenDegrees();
  for (const double f3 : {20.0, 45.0, 70.0}) {
    EXPECT_TRUE(anglesSymmetric(fromAngles(0.5, (180.0 - f3 + 9.9) * kDegree, f3 * kDegree, 1.0), rules)) << f3;
    EXPECT_FALSE(anglesSymmetric(fromAngles(0.5, (180.0 - f3 + 10.1) * kDegree, f3 * kDegree, 1.0), rules)) << f3;
    EXPECT_FALSE(anglesSymmetric(fromAngles(0.5, (180.0 - f3 - 10.1) * kDegree, f3 * kDegree, 1.0), rules)) << f3;
  }
}

TEST(VectorsTriangular, TurnsWhereF2MinusF3LeavesF4ByEpsilon) {
  const kernels::VotingRules rules = tenDegrees();
  for (const double f4 : {20.0, 60.0, 110.0}) {
    const double f2 = 0.5 * (180.0 + f4), f3 = 0.5 * (180.0 - f4);
    EXPECT_TRUE(vectorsTriangular(fromAngles(0.5, f2 * kDegree, f3 * kDegree, (f4 + 9.9) * kDegree), rules)) << f4;
    EXPECT_FALSE(vectorsTriangular(fromAngles(0.5, f2 * kDegree, f3 * kDegree, (f4 + 10.1) * kDegree), rules)) << f4;
    EXPECT_FALSE(vectorsTriangular(fromAngles(0.5, f2 * kDegree, f3 * kDegree, (f4 - 10.1) * kDegree), rules)) << f4;
  }
}

TEST(Conditions, HoldExactlyAsThePaperNestsThem) {
  Random random(3);
  const kernels::VotingRules rules = tenDegrees();
  for (int trial = 0; trial < 300; ++trial) {
    const Sphere sphere = {test::randomPoint(random), random.uniform(0.1, 1.0)};
    const Vec3 from = test::randomDirection(random), to = test::randomDirection(random);
    const PairFeatures on_sphere = featuresOf(pointOn(sphere, from), pointOn(sphere, to));
    EXPECT_TRUE(anglesSymmetric(on_sphere, rules) && vectorsTriangular(on_sphere, rules));

    const Cylinder cylinder = {test::randomPoint(random), test::randomDirection(random), random.uniform(0.1, 1.0)};
    const SurfacePoint low = pointOn(cylinder, {random.uniform(), random.uniform(0.0, 6.0)});
    const SurfacePoint high = pointOn(cylinder, {random.uniform(), random.uniform(0.0, 6.0)});
    const PairFeatures on_cylinder = featuresOf(low, high);
    EXPECT_TRUE(anglesSymmetric(on_cylinder, rules));

    const Plane plane = {test::randomPoint(random), test::randomDirection(random)};
    const SurfacePoint here = pointOn(plane, {random.uniform(), random.uniform()});
    const SurfacePoint there = pointOn(plane, {random.uniform(), random.uniform()});
    const PairFeatures on_plane = featuresOf(here, there);
    EXPECT_TRUE(normalsParallel(on_plane, rules) && pointsCoplanar(on_plane, rules));
  }
}

TEST(Conditions, TellACylinderPairApartFromASphere) {
  const Cylinder cylinder = {Vec3::Zero(), Vec3::UnitZ(), 0.1};
  const PairFeatures c = featuresOf(pointOn(cylinder, 0.0, 0.0), pointOn(cylinder, 0.3, 1.0));
  EXPECT_TRUE(anglesSymmetric(c, tenDegrees()));
  EXPECT_FALSE(vectorsTriangular(c, tenDegrees()));
}

TEST(Conditions, TellAConePairApartFromACylinder) {
  const Cone cone = {Vec3::Zero(), Vec3::UnitZ(), 30.0 * kDegree};
  const PairFeatures c = featuresOf(pointOn(cone, 0.2, 0.0), pointOn(cone, 0.8, 1.0));
  EXPECT_TRUE(isConvex(c));
  EXPECT_FALSE(anglesSymmetric(c, tenDegrees()));
}

TEST(ConstraintWeights, FallLinearlyFromOneToZeroAtEpsilon) {
  const float epsilon = static_cast<float>(10.0 * kDegree);
  EXPECT_NEAR(symmetryWeight(fromAngles(0.5, 120.0 * kDegree, 60.0 * kDegree, 1.0), epsilon), 1.0, 1e-3);
  EXPECT_NEAR(symmetryWeight(fromAngles(0.5, 125.0 * kDegree, 60.0 * kDegree, 1.0), epsilon), 0.5, 1e-3);
  EXPECT_NEAR(symmetryWeight(fromAngles(0.5, 120.0 * kDegree, 52.5 * kDegree, 1.0), epsilon), 0.25, 1e-3);
  EXPECT_EQ(symmetryWeight(fromAngles(0.5, 150.0 * kDegree, 60.0 * kDegree, 1.0), epsilon), 0.0f);
  EXPECT_NEAR(triangleWeight(fromAngles(0.5, 120.0 * kDegree, 60.0 * kDegree, 65.0 * kDegree), epsilon), 0.5, 1e-3);
}

TEST(ConstraintWeights, OfAPlaneMultiplyItsThreeConstraints) {
  const float epsilon = static_cast<float>(10.0 * kDegree);
  const double right = 90.0 * kDegree;
  EXPECT_NEAR(planeWeight(fromAngles(0.5, right, right, 0.0), epsilon), 1.0, 1e-3);
  EXPECT_NEAR(planeWeight(fromAngles(0.5, right, right, 5.0 * kDegree), epsilon), 0.5, 1e-3);
  EXPECT_NEAR(planeWeight(fromAngles(0.5, 95.0 * kDegree, 87.5 * kDegree, 5.0 * kDegree), epsilon), 0.5 * 0.75 * 0.5,
              1e-3);
}

TEST(PairRadius, IsThatOfSphereAndCylinder) {
  Random random(4);
  for (int trial = 0; trial < 300; ++trial) {
    const Sphere sphere = {test::randomPoint(random), random.uniform(0.05, 1.0)};
    const Vec3 from = test::randomDirection(random), to = test::randomDirection(random);
    const PairFeatures s = featuresOf(pointOn(sphere, from), pointOn(sphere, to));
    const Cylinder cylinder = {test::randomPoint(random), test::randomDirection(random), random.uniform(0.05, 1.0)};
    const SurfacePoint low = pointOn(cylinder, random.uniform(), 0.0);
    const SurfacePoint high = pointOn(cylinder, {random.uniform(), random.uniform(0.2, 3.0)});
    const PairFeatures c = featuresOf(low, high);
    if (s.c4 < std::cos(10.0 * kDegree)) {
      EXPECT_NEAR(pairRadius(s), sphere.radius, kRounding);
    }
    EXPECT_NEAR(pairRadius(c), cylinder.radius, kRounding);
  }
}

TEST(CylinderAngle, GivesTheAxisBackThroughTheLocalFrame) {
  Random random(5);
  for (int trial = 0; trial < 300; ++trial) {
    const Cylinder cylinder = {test::randomPoint(random), test::randomDirection(random), random.uniform(0.05, 1.0)};
    const SurfacePoint r = pointOn(cylinder, {random.uniform(), random.uniform(0.0, 6.0)});
    const SurfacePoint i = pointOn(cylinder, {random.uniform(), random.uniform(0.0, 6.0)});
    const Samples samples = test::samplesOf({r});
    const kernels::Reference reference = referenceAt(samples, 0);
    const float angle = cylinderAngle(reference, toKernel(i));
    EXPECT_GE(angle, 0.0f);
    EXPECT_LT(angle, static_cast<float>(M_PI));
    const Vec3 y(reference.tangent_y.x, reference.tangent_y.y, reference.tangent_y.z);
    const Vec3 z(reference.tangent_z.x, reference.tangent_z.y, reference.tangent_z.z);
    if (std::abs(r.normal.dot(i.normal)) > std::cos(10.0 * kDegree)) continue;
    EXPECT_LT(test::lineAngle(std::cos(angle) * y + std::sin(angle) * z, cylinder.axis), 1e-4);
  }
}

TEST(ConeVotes, GiveAxisDistanceAndAxisDirection) {
  Random random(6);
  for (int trial = 0; trial < 300; ++trial) {
    const Cone cone = {test::randomPoint(random), test::randomDirection(random), random.uniform(0.15, 1.2)};
    const double height = random.uniform(0.2, 1.0);
    const SurfacePoint r = pointOn(cone, height, 0.0);
    const SurfacePoint i = pointOn(cone, {random.uniform(0.2, 1.0), random.uniform(0.7, 2.5)});
    const PairFeatures c = featuresOf(r, i);
    // From the surface along the normal to the axis: h tan(theta) / cos(theta).
    EXPECT_NEAR(coneAxisDistance(c), height * std::tan(cone.half_angle) / std::cos(cone.half_angle), 1e-3);
    const kernels::Vector axis = coneAxis(toKernel(r), toKernel(i), c);
    const Vec3 direction(axis.x, axis.y, axis.z);
    if (direction.norm() > 0.05) {
      EXPECT_LT(test::lineAngle(direction, cone.axis), 0.01);
    }
  }
}

}  // namespace
}  // namespace primitect::features_test
