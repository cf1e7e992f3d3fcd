// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which samples belong to which shape.
#include "core/segmentation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "test/support/candidates.h"
#include "test/support/exact_shapes.h"

namespace primitect::segmentation_test {
namespace {

using test::candidate;
using test::kDegree;
using test::patchOf;
using test::SurfacePoint;

/// 10 mm and 20 deg.
const Tolerance kTolerance = {NoiseModel{0.01}, std::cos(20.0 * kDegree), 1.0};

TEST(Segmentation, ExplainsEachSampleAtMostOnce) {
  Random random(33);
  const Sphere a = {Vec3(0, 0, 1), 0.1}, b = {Vec3(0.3, 0, 1), 0.1};
  std::vector<SurfacePoint> points = patchOf(a, 100, random);
  for (const SurfacePoint& p : patchOf(b, 100, random)) points.push_back(p);
  const Samples samples = test::samplesOf(points);
  Params few;
  few.min_inliers = 30;
  const Sphere double_of_a = {Vec3(0, 0, 1.002), 0.101};
  List<Segment> segments;
  selectSegments(samples,
                 {candidate(a, points[0], 9), candidate(double_of_a, points[0], 5), candidate(b, points[150], 3)}, few,
                 kTolerance, segments);
  ASSERT_EQ(segments.size(), 2u);
  assignSamples(samples, few, kTolerance, segments);
  EXPECT_EQ(segments[0].inliers.size(), 100u);
  EXPECT_EQ(segments[1].inliers.size(), 100u);
  EXPECT_EQ(std::get<Sphere>(segments[1].candidate.shape).center, b.center);
}

TEST(Segmentation, AsksForDistanceNormalAndNumber) {
  Random random(34);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  std::vector<SurfacePoint> points = patchOf(plane, 30, 0.3, random);
  for (int k = 0; k < 15; ++k) points[k].normal = Vec3::UnitX();
  Params params;
  params.min_inliers = 15;
  List<Segment> segments;
  selectSegments(test::samplesOf(points), {candidate(plane, points[20], 9)}, params, kTolerance, segments);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].inliers.size(), 15u);
  params.min_inliers = 16;
  segments.clear();
  selectSegments(test::samplesOf(points), {candidate(plane, points[20], 9)}, params, kTolerance, segments);
  EXPECT_TRUE(segments.empty());
  params.min_inliers = 3;
  const Plane moved = {Vec3(0, 0, 1.011), -Vec3::UnitZ()};  // tolerance 10 mm
  segments.clear();
  selectSegments(test::samplesOf(points), {candidate(moved, points[20], 9)}, params, kTolerance, segments);
  EXPECT_TRUE(segments.empty());
}

TEST(Segmentation, RefusesShapesBeyondTheLimits) {
  Params params;
  params.min_radius = 0.02;
  params.max_radius = 0.5;
  EXPECT_TRUE(withinLimits(Sphere{Vec3::Zero(), 0.1}, params));
  EXPECT_FALSE(withinLimits(Sphere{Vec3::Zero(), 0.01}, params));
  EXPECT_FALSE(withinLimits(Cylinder{Vec3::Zero(), Vec3::UnitX(), 0.6}, params));
  EXPECT_FALSE(withinLimits(Sphere{Vec3::Zero(), std::nan("")}, params));
  EXPECT_FALSE(withinLimits(Cone{Vec3::Zero(), Vec3::UnitX(), 80 * kDegree}, params));
  EXPECT_FALSE(withinLimits(Cone{Vec3::Zero(), Vec3::UnitX(), 2 * kDegree}, params));
  EXPECT_TRUE(withinLimits(Plane{}, params));
}

TEST(Segmentation, LeavesSharpConesToThePointsOfTheCloud) {
  const Cone cup = {Vec3::Zero(), Vec3::UnitX(), 6 * kDegree}, funnel = {Vec3::Zero(), Vec3::UnitX(), 9 * kDegree};
  Params params;
  ASSERT_TRUE(withinLimits(cup, params));
  EXPECT_FALSE(withinLimits(cup, limitsForSamples(params)));
  EXPECT_TRUE(withinLimits(funnel, limitsForSamples(params)));
  params.min_half_angle_deg = 12.0;
  EXPECT_FALSE(withinLimits(funnel, limitsForSamples(params))) << "narrower than asked for";
  // Nothing else would find it.
  params.min_half_angle_deg = 5.0;
  params.detect_cylinders = false;
  EXPECT_TRUE(withinLimits(cup, limitsForSamples(params)));
  params.detect_cylinders = true;
  params.verify = false;
  EXPECT_TRUE(withinLimits(cup, limitsForSamples(params)));
}

}  // namespace
}  // namespace primitect::segmentation_test
