// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The kinds compete for the samples of a candidate.
#include "core/verification.h"

#include <gtest/gtest.h>

#include "test/support/candidates.h"
#include "test/support/exact_shapes.h"

namespace primitect {
namespace {

using test::patchOf;
using test::SurfacePoint;

constexpr double kDegree = M_PI / 180.0;
constexpr double kNoise = 0.001;
constexpr double kMaxRadius = 0.4;

const Tolerance kLoose = {0.012, 0.0, std::cos(30.0 * kDegree)};
const Tolerance kTight = {3.0 * kNoise, 0.0, std::cos(30.0 * kDegree)};

std::vector<SurfacePoint> noisy(std::vector<SurfacePoint> points, std::uint64_t seed) {
  Random random(seed);
  for (SurfacePoint& p : points) p.point += kNoise * random.gaussian() * p.normal;
  return points;
}

Candidate proposal(const Shape& shape, const SurfacePoint& reference) {
  return test::candidate(shape, reference, 100.0);
}

std::vector<Segment> verified(const std::vector<SurfacePoint>& points, const std::vector<Candidate>& candidates,
                              const Params& params = Params()) {
  std::vector<Segment> segments;
  verifyCandidates(test::samplesOf(points), candidates, params, kLoose, kTight, kMaxRadius, segments);
  return segments;
}

TEST(Verification, TurnsAPlaneOnACylinderIntoTheCylinder) {
  Random random(71);
  const Cylinder cylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
  const std::vector<SurfacePoint> points = noisy(patchOf(cylinder, 400, -0.1, 0.1, random), 1);
  const Plane tangent = {Vec3(0, 0, 0.955), Vec3(0, 0, -1)};
  const std::vector<Segment> segments = verified(points, {proposal(tangent, points[0]), proposal(cylinder, points[1])});
  ASSERT_EQ(segments.size(), 1u);
  const Cylinder* found = std::get_if<Cylinder>(&segments[0].candidate.shape);
  ASSERT_TRUE(found);
  // Fitted to the strip around the tangent plane alone; the final refinement sees all inliers.
  EXPECT_NEAR(found->radius, 0.05, 0.0015);
  EXPECT_GT(segments[0].inliers.size(), 380u);
}

TEST(Verification, LeavesNothingForAConeOverTwoFacesOfABox) {
  Random random(72);
  const Plane front = {Vec3(0, 0, 1), Vec3(0, 0, -1)}, top = {Vec3(0, -0.1, 1.1), Vec3(0, -1, 0)};
  std::vector<SurfacePoint> points = patchOf(front, 200, 0.1, random);
  for (const SurfacePoint& p : patchOf(top, 200, 0.1, random)) points.push_back(p);
  points = noisy(points, 2);
  // The cone that touches both faces along lines through their common edge.
  const Cone cone = {Vec3(-0.1, -0.1, 1.0), Vec3(1, 1, 1).normalized(), std::asin(std::sqrt(1.0 / 3.0))};
  const std::vector<Segment> segments =
      verified(points, {proposal(front, points[0]), proposal(top, points[300]), proposal(cone, points[1])});
  ASSERT_EQ(segments.size(), 2u);
  for (const Segment& segment : segments) EXPECT_EQ(kindOf(segment.candidate.shape), Kind::plane);
}

TEST(Refinement, OfSegmentsUsesAllTheirInliers) {
  Random random(78);
  const Cylinder cylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
  const std::vector<SurfacePoint> points = noisy(patchOf(cylinder, 400, -0.1, 0.1, random), 8);
  std::vector<Segment> segments =
      verified(points, {proposal(Cylinder{Vec3(0, 0, 1.001), Vec3(0, -1, 0), 0.051}, points[0])});
  ASSERT_EQ(segments.size(), 1u);
  refineSegments(test::samplesOf(points), Params(), kTight, kMaxRadius, segments);
  // sigma / sqrt(400) for the distances, times about 4 as half a turn is seen at most; three of these.
  EXPECT_NEAR(std::get<Cylinder>(segments[0].candidate.shape).radius, 0.05, 3.0 * 4.0 * kNoise / 20.0);
}

TEST(Verification, KeepsEveryKindOnItsOwnPoints) {
  Random random(73);
  const Sphere sphere = {Vec3(0, 0, 1), 0.08};
  const Cone cone = {Vec3(0, -0.1, 1), Vec3(0, 1, 0), 25 * kDegree};
  const Plane plane = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  const std::vector<std::pair<Shape, std::vector<SurfacePoint>>> cases = {{sphere, patchOf(sphere, 300, random)},
                                                                          {cone, patchOf(cone, 300, 0.05, 0.2, random)},
                                                                          {plane, patchOf(plane, 300, 0.1, random)}};
  for (const auto& [shape, points] : cases) {
    const std::vector<SurfacePoint> measured = noisy(points, 3);
    const std::vector<Segment> segments = verified(measured, {proposal(shape, measured[0])});
    ASSERT_EQ(segments.size(), 1u) << kindName(kindOf(shape));
    EXPECT_EQ(segments[0].candidate.shape.index(), shape.index()) << kindName(kindOf(shape));
  }
}

TEST(Verification, ExplainsEachSampleOnce) {
  Random random(74);
  const Sphere sphere = {Vec3(0, 0, 1), 0.08};
  const std::vector<SurfacePoint> points = noisy(patchOf(sphere, 300, random), 4);
  const Sphere shifted = {Vec3(0, 0.004, 1), 0.083};
  EXPECT_EQ(verified(points, {proposal(sphere, points[0]), proposal(shifted, points[1])}).size(), 1u);
}

TEST(Verification, KeepsLimitsAfterRefinement) {
  Random random(75);
  const Sphere sphere = {Vec3(0, 0, 1), 0.08};
  const std::vector<SurfacePoint> points = noisy(patchOf(sphere, 300, random), 5);
  // The proposal is within the limit, the fit is not.
  Params params;
  params.max_radius = 0.078;
  for (const Segment& segment : verified(points, {proposal(Sphere{Vec3(0, 0, 0.997), 0.077}, points[0])}, params)) {
    EXPECT_NE(kindOf(segment.candidate.shape), Kind::sphere);
  }
}

TEST(Verification, DoesNotTurnAKindOnThatIsOff) {
  Random random(76);
  const Cylinder cylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
  const std::vector<SurfacePoint> points = noisy(patchOf(cylinder, 400, -0.1, 0.1, random), 6);
  Params params;
  params.detect_cylinders = false;
  for (const Segment& segment :
       verified(points, {proposal(Plane{Vec3(0, 0, 0.955), Vec3(0, 0, -1)}, points[0])}, params)) {
    EXPECT_NE(kindOf(segment.candidate.shape), Kind::cylinder);
  }
}

TEST(NoiseTolerance, IsThreeStandardDeviationsOfWhatFitsBest) {
  Random random(77);
  const Sphere sphere = {Vec3(0, 0, 1), 0.2};
  const std::vector<SurfacePoint> points = noisy(patchOf(sphere, 1000, random), 7);
  const double tolerance = estimateNoiseTolerance(test::samplesOf(points), {proposal(sphere, points[0])}, kLoose);
  EXPECT_NEAR(tolerance, 3.0 * kNoise, 0.5 * kNoise);
}

TEST(NoiseTolerance, IsTheLooseOneWhenThereIsNothingToMeasure) {
  EXPECT_EQ(estimateNoiseTolerance(test::samplesOf({}), {}, kLoose), kLoose.distance);
}

}  // namespace
}  // namespace primitect
