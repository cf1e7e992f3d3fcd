// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cups and cans on a face, of which one side is seen: what leans on it, and what stands.
#include "core/upright.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/fitting.h"
#include "test/support/hypotheses.h"

namespace primitect::upright_test {
namespace {

using test::kDegree;
using test::SurfacePoint;

/// Before the camera; the face below has its normal upwards, to the camera's y = -1.
const Vec3 kUp = -Vec3::UnitY(), kMiddle = Vec3(0.02, 0.01, 1.0);
constexpr double kRadius = 0.036, kHeight = 0.09;

const Cylinder kCan = {kMiddle, kUp, kRadius};

/// The cone of this half angle around the middle, whose wide end is above or below.
Cone cup(double half_angle, bool wide_above) {
  const Vec3 axis = wide_above ? kUp : Vec3(-kUp);
  return {kMiddle - kRadius / std::tan(half_angle) * axis, axis, half_angle};
}

FitPoints pointsOf(const Cone& cone, std::uint64_t seed) {
  constexpr int kCount = 1200;
  Random random(seed);
  const double middle = kRadius / std::tan(cone.half_angle);
  const auto points = test::patchOf(cone, kCount, middle - 0.5 * kHeight, middle + 0.5 * kHeight, random);
  return test::fitPointsOf(test::noisySamples(points, 0.0, random));
}

FitPoints pointsOf(const Cylinder& can, std::uint64_t seed) {
  constexpr int kCount = 1200;
  Random random(seed);
  const auto points = test::patchOf(can, kCount, -0.5 * kHeight, 0.5 * kHeight, random);
  return test::fitPointsOf(test::noisySamples(points, 0.0, random));
}

/// The cylinder that fits the points best.
Cylinder leaningFit(const FitPoints& points) {
  RefineRules rules;
  rules.most_steps = 30;
  return std::get<Cylinder>(*refine(kCan, points, rules));
}

double leanOf(const Vec3& axis) { return std::acos(std::min(1.0, std::abs(axis.dot(kUp)))); }

const Params kParams;
const Limits kLimits = {kParams, 0.5};

TEST(UprightShape, OfACylinderThatLeansAsMuchAsACupTapersIsTheCup) {
  constexpr double kHalfAngle = 6.0 * kDegree;
  for (const bool wide_above : {false, true}) {
    const FitPoints points = pointsOf(cup(kHalfAngle, wide_above), 1);
    const Cylinder found = leaningFit(points);
    ASSERT_GT(leanOf(found.axis), 5.0 * kDegree) << "that is the mistake";
    for (const Vec3& normal : {kUp, Vec3(-kUp)}) {
      const std::optional<Shape> upright = uprightShape(found, normal, Leaning::clear, points, kLimits);
      ASSERT_TRUE(upright);
      ASSERT_EQ(kindOf(*upright), Kind::cone);
      const Cone& cone = std::get<Cone>(*upright);
      EXPECT_NEAR(cone.half_angle, kHalfAngle, 0.6 * kDegree);
      EXPECT_NEAR(cone.axis.dot(kUp), wide_above ? 1.0 : -1.0, 1e-12) << "the axis is the face's normal";
    }
  }
}

TEST(UprightShape, OfAConeThatLeansIsTheOneThatStands) {
  constexpr double kHalfAngle = 9.0 * kDegree;
  const FitPoints points = pointsOf(cup(kHalfAngle, true), 2);
  Cone found = cup(6.0 * kDegree, true);
  found.axis = Eigen::AngleAxisd(-4.0 * kDegree, Vec3::UnitX()) * found.axis;
  const auto fit = refine(found, points, {1.0, 0, 1});
  ASSERT_TRUE(fit);
  const std::optional<Shape> upright = uprightShape(*fit, kUp, Leaning::any, points, kLimits);
  ASSERT_TRUE(upright && kindOf(*upright) == Kind::cone);
  EXPECT_NEAR(std::get<Cone>(*upright).half_angle, kHalfAngle, 0.6 * kDegree);
}

/// A can that a fit has turned.
TEST(UprightShape, OfAStandingCanIsTheCan) {
  const FitPoints points = pointsOf(kCan, 3);
  const Cylinder turned = {kMiddle, Eigen::AngleAxisd(3.0 * kDegree, Vec3::UnitX()) * kUp, kRadius};
  const std::optional<Shape> upright = uprightShape(turned, kUp, Leaning::clear, points, kLimits);
  ASSERT_TRUE(upright);
  ASSERT_EQ(kindOf(*upright), Kind::cylinder);
  EXPECT_NEAR(std::get<Cylinder>(*upright).radius, kRadius, 0.001);
}

TEST(UprightShape, OfWhatHardlyLeansIsOnlyThereForThoseWhoAsk) {
  const FitPoints points = pointsOf(kCan, 4);
  const Cylinder found = leaningFit(points);
  ASSERT_LT(leanOf(found.axis), 1.0 * kDegree);
  EXPECT_FALSE(uprightShape(found, kUp, Leaning::clear, points, kLimits));
  EXPECT_TRUE(uprightShape(found, kUp, Leaning::any, points, kLimits));
}

/// Sideways no taper looks like a lean.
TEST(UprightShape, IsNoneWhereThePointsTellThatItLeans) {
  const Cylinder can = {kMiddle, Eigen::AngleAxisd(8.0 * kDegree, Vec3::UnitZ()) * kUp, kRadius};
  const FitPoints points = pointsOf(can, 5);
  EXPECT_FALSE(uprightShape(can, kUp, Leaning::clear, points, kLimits));
}

TEST(UprightShape, KeepsToTheLimits) {
  const FitPoints points = pointsOf(cup(6.0 * kDegree, true), 6);
  const Cylinder found = leaningFit(points);
  Params params;
  params.min_half_angle_deg = 8.0;
  EXPECT_FALSE(uprightShape(found, kUp, Leaning::clear, points, {params, 0.5}));
  params.min_half_angle_deg = 4.0;
  EXPECT_TRUE(uprightShape(found, kUp, Leaning::clear, points, {params, 0.5}));
  params.detect_cones = false;
  EXPECT_FALSE(uprightShape(found, kUp, Leaning::clear, points, {params, 0.5}));
}

TEST(UprightShape, IsNoneWithoutPoints) { EXPECT_FALSE(uprightShape(kCan, kUp, Leaning::any, FitPoints(), kLimits)); }

TEST(UprightShape, IsNoneOfPlanesAndBalls) {
  const FitPoints points = pointsOf(kCan, 7);
  EXPECT_FALSE(uprightShape(Plane{kMiddle, Vec3::UnitZ()}, kUp, Leaning::any, points, kLimits));
  EXPECT_FALSE(uprightShape(Sphere{kMiddle, kRadius}, kUp, Leaning::any, points, kLimits));
}

}  // namespace
}  // namespace primitect::upright_test
