// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
#include "core/determination.h"

#include <gtest/gtest.h>

namespace primitect::determination_test {
namespace {

Uncertainty uncertain(double radius_stddev, double half_angle_stddev = 0.0) {
  return {{}, radius_stddev, half_angle_stddev, 0.0, 0.0};
}

TEST(TrustInSize, IsFullWhereThePointsDetermineTheRadius) {
  EXPECT_EQ(trustInSize(Sphere{Vec3::Zero(), 0.1}, uncertain(0.001)), 1.0);
  EXPECT_EQ(trustInSize(Cylinder{Vec3::Zero(), Vec3::UnitZ(), 0.1}, uncertain(0.0095)), 1.0);
}

TEST(TrustInSize, IsGoneWhereTheRadiusIsLeftOpen) {
  EXPECT_EQ(trustInSize(Sphere{Vec3::Zero(), 0.1}, uncertain(0.01)), 0.0);
  EXPECT_EQ(trustInSize(Cylinder{Vec3::Zero(), Vec3::UnitZ(), 0.1}, uncertain(0.0205)), 0.0);
}

TEST(TrustInSize, GoesDownInBetween) {
  double before = 1.0;
  for (const double deviation : {0.03, 0.035, 0.04, 0.045}) {
    const double trust = trustInSize(Sphere{Vec3::Zero(), 1.0}, uncertain(deviation));
    EXPECT_LT(trust, before);
    EXPECT_GT(trust, 0.0);
    before = trust;
  }
}

TEST(TrustInSize, OfAConeIsThatInItsHalfAngle) {
  const Cone cone = {Vec3::Zero(), Vec3::UnitZ(), 0.3};
  EXPECT_EQ(trustInSize(cone, uncertain(1.0, 0.02)), 1.0);
  EXPECT_EQ(trustInSize(cone, uncertain(0.0, 0.15)), 0.0);
}

TEST(TrustInSize, OfASharpConeAsksWhetherItIsACylinder) {
  const Cone cone = {Vec3::Zero(), Vec3::UnitZ(), 0.08};
  EXPECT_EQ(trustInSize(cone, uncertain(0.0, 0.02)), 1.0);
  EXPECT_LT(trustInSize(cone, uncertain(0.0, 0.045)), 0.5);
  EXPECT_EQ(trustInSize(cone, uncertain(0.0, 0.06)), 0.0);
}

TEST(TrustInSize, IsFullForPlanesWhichHaveNone) {
  EXPECT_EQ(trustInSize(Plane{Vec3::Zero(), Vec3::UnitZ()}, uncertain(1.0, 1.0)), 1.0);
}

}  // namespace
}  // namespace primitect::determination_test
