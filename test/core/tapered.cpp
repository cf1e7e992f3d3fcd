// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From cylinders to cones.
#include "core/tapered.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/fitting.h"
#include "test/support/hypotheses.h"

namespace primitect::tapered_test {
namespace {

constexpr double kDegree = test::kDegree;
constexpr double kRadius = 0.05;  // m, of curvature at the middle of the patch
constexpr double kReach = 0.025;  // m, of the patch along its length
constexpr double kArc = 0.7;      // rad, of the patch to either side

const Vec3 kSeen(0.1, -0.2, 1.0);                // the middle of the patch, which faces the sensor
const Vec3 kOutward(0, 0, -1), kAlong(0, 1, 0);  // there

/// The cylinder that touches the patch.
const Cylinder kTouching = {kSeen - kRadius * kOutward, kAlong, kRadius};

/// The cone that touches it, too, and opens to this side (1 or -1).
Cone touchingCone(double half_angle, double way) {
  const Vec3 opening = way * kAlong;
  return {kSeen - kRadius / std::tan(half_angle) * opening,
          std::cos(half_angle) * opening - std::sin(half_angle) * kOutward, half_angle};
}

/// Noisy points of the cone around the middle of the patch.
Samples patchOfCone(const Cone& cone, std::uint64_t seed) {
  constexpr int kCount = 400;
  Random random(seed);
  const Vec3 x = cone.axis.unitOrthogonal();
  const double front = std::atan2(kOutward.dot(cone.axis.cross(x)), kOutward.dot(x));
  const double middle = (kSeen - cone.apex).norm();
  std::vector<test::SurfacePoint> points;
  for (int k = 0; k < kCount; ++k) {
    const double slant = middle + random.uniform(-kReach, kReach);
    points.push_back(test::pointOn(cone, slant * std::cos(cone.half_angle), front + random.uniform(-kArc, kArc)));
  }
  return test::noisySamples(points, 0.0, random);
}

TEST(Agreement, IsOneForEachPointOnTheShapeAndNothingForOneBeyondTheTolerance) {
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  const auto at = [](double z) { return test::SurfacePoint{Vec3(0, 0, z), -Vec3::UnitZ()}; };
  const double tolerance = kInlierDeviations * test::kNoise;
  const Samples samples =
      test::samplesWith(test::kNoiseModel, {at(1.0), at(1.0 + 0.5 * tolerance), at(1.0 - 2.0 * tolerance)});
  // Points are in float, a tenth of a micrometre apart.
  EXPECT_NEAR(agreement(plane, test::fitPointsOf(samples)), 1.0 + 0.75, 1e-3);
}

TEST(Refine, FindsAConeThatOpensTheOtherWay) {
  const Cone truth = touchingCone(12.0 * kDegree, 1.0);
  const FitPoints points = test::fitPointsOf(patchOfCone(truth, 5));
  const std::optional<Shape> fitted = refine(touchingCone(4.0 * kDegree, -1.0), points);
  ASSERT_TRUE(fitted);
  EXPECT_GT(std::get<Cone>(*fitted).axis.dot(kAlong), 0.0);
  EXPECT_GE(agreement(*fitted, points), agreement(truth, points) - 1.0);
}

TEST(Tapered, IsAConeThatTouchesTheCylinderWhereThePointsLie) {
  const Samples samples = patchOfCone(touchingCone(20.0 * kDegree, 1.0), 3);
  const FitPoints points = test::fitPointsOf(samples);
  const Cone cone = tapered(kTouching, points);
  const Vec3 seen = points.middle() - distance(kTouching, points.middle()) * normalAt(kTouching, points.middle());
  EXPECT_NEAR(distance(cone, seen), 0.0, 1e-9);
  EXPECT_GT(normalAt(cone, seen).dot(normalAt(kTouching, seen)), 1.0 - 1e-9);
}

TEST(Tapered, AgreesBetterThanTheCylinderAndOpensAsThePointsDo) {
  for (const double way : {-1.0, 1.0}) {
    for (const double degrees : {12.0, 20.0, 30.0}) {
      const FitPoints points = test::fitPointsOf(patchOfCone(touchingCone(degrees * kDegree, way), 4));
      const Cone cone = tapered(kTouching, points);
      EXPECT_GT(cone.axis.dot(way * kAlong), 0.0) << degrees;
      EXPECT_GT(agreement(cone, points), agreement(kTouching, points)) << degrees;
    }
  }
}

TEST(Tapered, IsWhereTheFitOfAConeGetsToTheTruth) {
  for (const double way : {-1.0, 1.0}) {
    for (const double degrees : {10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 45.0, 55.0}) {
      const Cone truth = touchingCone(degrees * kDegree, way);
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const FitPoints points = test::fitPointsOf(patchOfCone(truth, seed));
        const std::optional<Shape> fitted = refine(tapered(kTouching, points), points);
        const std::optional<Shape> from_truth = refine(truth, points);
        ASSERT_TRUE(fitted && from_truth);
        EXPECT_NEAR(std::get<Cone>(*fitted).half_angle, std::get<Cone>(*from_truth).half_angle, 0.5 * kDegree)
            << way << " " << degrees << " " << seed;
        // What the fit minimises weighs the points a little differently: 0.3 of 350 below the truth at most.
        EXPECT_GE(agreement(*fitted, points), agreement(truth, points) - 1.0) << way << " " << degrees << " " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace primitect::tapered_test
