// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From votes to shapes seen from inside: bowls, tubes, funnels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test/support/candidates.h"
#include "test/support/exact_shapes.h"

namespace primitect::concave_voting_test {
namespace {

using test::bowlOf;
using test::candidatesOf;
using test::expectWithinBins;
using test::kDegree;
using test::patchOf;
using test::shapesOf;
using test::SurfacePoint;
using test::wallOf;

Params paperWith(const char* convexity) {
  Params params = presetParams("paper");
  params.convexity = convexity;
  return params;
}

/// Each shape's surface holds its reference, whose normal is the shape's inward one and still points to the sensor.
void expectSeenFromInside(const List<Candidate>& candidates) {
  EXPECT_FALSE(candidates.empty());
  for (const Candidate& candidate : candidates) {
    EXPECT_TRUE(candidate.concave);
    EXPECT_LT(std::abs(distance(candidate.shape, candidate.point)), 1e-6);
    EXPECT_GT(candidate.normal.dot(-normalAt(candidate.shape, candidate.point)), 1.0 - 1e-6);
    EXPECT_LT(candidate.normal.dot(candidate.point), 0.0);
  }
}

TEST(ConcaveVotes, FindTheInsideOfASphere) {
  Random random(41);
  const Sphere sphere = {Vec3(0.1, 0.0, 1.0), 0.1033};
  const List<Candidate> candidates = candidatesOf(bowlOf(sphere, 300, random), 2.0, paperWith("concave"));
  expectSeenFromInside(candidates);
  test::expectExact(shapesOf<Sphere>(candidates), sphere);
}

TEST(ConcaveVotes, FindTheWallOfATube) {
  Random random(42);
  Params params = paperWith("concave");
  params.detect_cones = false;
  for (int trial = 0; trial < 5; ++trial) {
    const Cylinder tube = {Vec3(0.0, 0.0, 1.2), test::randomDirection(random), random.uniform(0.06, 0.2)};
    const List<Candidate> candidates = candidatesOf(wallOf(tube, 400, -0.2, 0.2, random), 2.0, params);
    expectSeenFromInside(candidates);
    expectWithinBins(shapesOf<Cylinder>(candidates), tube);
  }
}

TEST(ConcaveVotes, FindTheInsideOfACone) {
  Random random(43);
  Params params = paperWith("concave");
  params.detect_planes = params.detect_cylinders = params.detect_spheres = false;
  for (int trial = 0; trial < 6; ++trial) {
    const Cone cone = {Vec3(0.0, 0.0, 1.0), -test::randomDirectionAway(random), random.uniform(15.0, 45.0) * kDegree};
    const List<Candidate> candidates = candidatesOf(wallOf(cone, 500, 0.05, 0.3, random), 2.0, params);
    expectSeenFromInside(candidates);
    SCOPED_TRACE(trial);
    expectWithinBins(shapesOf<Cone>(candidates), cone);
  }
}

TEST(ConcaveVotes, AreNotAskedForByConvex) {
  Random random(44);
  EXPECT_TRUE(candidatesOf(bowlOf({Vec3(0.0, 0.0, 1.0), 0.1}, 300, random), 2.0, paperWith("convex")).empty());
  EXPECT_TRUE(candidatesOf(patchOf(Sphere{Vec3(0.0, 0.0, 1.0), 0.1}, 300, random), 2.0, paperWith("concave")).empty());
}

TEST(ConcaveVotes, AndConvexOnesFindABallAndABowlInOneCloud) {
  Random random(45);
  const Sphere ball = {Vec3(-0.3, 0.0, 1.0), 0.08}, bowl = {Vec3(0.3, 0.0, 1.0), 0.12};
  std::vector<SurfacePoint> points = patchOf(ball, 300, random);
  for (const SurfacePoint& p : bowlOf(bowl, 300, random)) points.push_back(p);
  int balls = 0, bowls = 0;
  for (const Candidate& candidate : candidatesOf(points, 2.0, paperWith("both"))) {
    const Sphere* found = std::get_if<Sphere>(&candidate.shape);
    if (!found) continue;
    const Sphere& truth = candidate.concave ? bowl : ball;
    EXPECT_NEAR(found->radius, truth.radius, 1e-4);
    EXPECT_LT((found->center - truth.center).norm(), 2e-4);
    ++(candidate.concave ? bowls : balls);
  }
  EXPECT_GT(balls, 250);
  EXPECT_GT(bowls, 250);
}

TEST(ConcaveVotes, LeavePlanesPlanes) {
  Random random(46);
  const Plane plane = {Vec3(0.0, 0.2, 1.0), Vec3(0.1, -0.9, -0.3).normalized()};
  const std::vector<SurfacePoint> points = patchOf(plane, 200, 0.2, random);
  for (const char* convexity : {"concave", "both"}) {
    const List<Candidate> candidates = candidatesOf(points, 2.0, paperWith(convexity));
    EXPECT_GT(shapesOf<Plane>(candidates).size(), 150u) << convexity;
    for (const Candidate& candidate : candidates) EXPECT_FALSE(candidate.concave);
  }
}

}  // namespace
}  // namespace primitect::concave_voting_test
