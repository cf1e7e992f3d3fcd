// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parameter errors of shapes that were moved and turned by known amounts.
#include "eval/parameter_errors.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "eval/test/hand_made.h"

namespace parameter_errors_test {
namespace {

using namespace primitect;
using namespace primitect::eval;

constexpr double kTiny = 1e-9;

ParameterErrors errorsOf(const Shape& truth, const Shape& found, const Vec3& place = Vec3::Zero()) {
  ParameterErrors errors;
  addErrors(truth, found, place, errors);
  return errors;
}

TEST(ParameterErrors, OfAPlaneAreTakenWhereItsPointsAre) {
  const Plane truth{Vec3::Zero(), Vec3::UnitZ()};
  // Tilted by 10 deg around the x axis: 1 m along y it is sin(10 deg) away.
  const ParameterErrors errors = errorsOf(truth, Plane{Vec3::Zero(), -tilted(10)}, Vec3(5, 1, 0));
  ASSERT_EQ(errors.position.size(), 1u);
  EXPECT_NEAR(errors.position[0], std::sin(10 * kDegree), kTiny);
  EXPECT_NEAR(errors.axis_deg.at(0), 10.0, kTiny);
  EXPECT_TRUE(errors.radius.empty() && errors.apex.empty() && errors.half_angle_deg.empty());
}

TEST(ParameterErrors, OfAPlaneDoNotCountHowFarThePlaceIsFromIt) {
  EXPECT_NEAR(errorsOf(Plane(), Plane(), Vec3(1, 2, 0.3)).position.at(0), 0.0, kTiny);
}

TEST(ParameterErrors, OfASphereAreCentreAndRadius) {
  const ParameterErrors errors = errorsOf(Sphere{Vec3(1, 2, 3), 0.5}, Sphere{Vec3(1, 2.03, 3.04), 0.48});
  EXPECT_NEAR(errors.position.at(0), 0.05, kTiny);
  EXPECT_NEAR(errors.radius.at(0), 0.02, kTiny);
  EXPECT_TRUE(errors.axis_deg.empty());
}

TEST(ParameterErrors, OfACylinderIgnoreWhereOnTheAxisItsPointLiesAndWhichWayItPoints) {
  const Cylinder truth{Vec3(0, 0, 0), Vec3::UnitX(), 0.1};
  const ParameterErrors errors = errorsOf(truth, Cylinder{Vec3(7, 0.003, 0.004), -Vec3::UnitX(), 0.11}, Vec3(2, 0, 0));
  EXPECT_NEAR(errors.position.at(0), 0.005, kTiny);
  EXPECT_NEAR(errors.radius.at(0), 0.01, kTiny);
  EXPECT_NEAR(errors.axis_deg.at(0), 0.0, kTiny);
}

TEST(ParameterErrors, OfATiltedCylinderAreTakenBesideItsPoints) {
  const Cylinder truth{Vec3(-3, 0, 0), Vec3::UnitZ(), 0.1};
  const Cylinder found{Vec3(-3, 0, 0), tilted(5), 0.1};
  const ParameterErrors errors = errorsOf(truth, found, Vec3(-2.9, 0, 2));
  EXPECT_NEAR(errors.position.at(0), 2.0 * std::sin(5 * kDegree), kTiny);
  EXPECT_NEAR(errors.axis_deg.at(0), 5.0, kTiny);
}

TEST(ParameterErrors, OfAConeKnowWhichWayItOpens) {
  const Cone truth{Vec3::Zero(), Vec3::UnitZ(), 20 * kDegree};
  const ParameterErrors errors = errorsOf(truth, Cone{Vec3(0, 0.6, 0.8), tilted(3), 22.5 * kDegree});
  EXPECT_NEAR(errors.apex.at(0), 1.0, kTiny);
  EXPECT_NEAR(errors.axis_deg.at(0), 3.0, kTiny);
  EXPECT_NEAR(errors.half_angle_deg.at(0), 2.5, kTiny);
  EXPECT_NEAR(errorsOf(truth, Cone{Vec3::Zero(), -Vec3::UnitZ(), 0.3}).axis_deg.at(0), 180.0, kTiny);
}

TEST(ParameterErrors, ResolveAnglesFarBelowAnArcCosine) {
  EXPECT_NEAR(errorsOf(Plane(), Plane{Vec3::Zero(), tilted(1e-7)}).axis_deg.at(0), 1e-7, 1e-12);
}

TEST(ParameterErrors, RefuseShapesOfDifferentKinds) {
  EXPECT_THROW(errorsOf(Sphere{Vec3::Zero(), 1.0}, Plane()), std::invalid_argument);
}

}  // namespace
}  // namespace parameter_errors_test
