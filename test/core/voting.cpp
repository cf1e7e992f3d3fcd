// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From votes to shapes: peaks between bins, recovery of the cone, candidates of exact surfaces, ablations.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/pair_voting.h"
#include "test/support/candidates.h"
#include "test/support/exact_shapes.h"

namespace primitect::voting_test {
namespace {

using test::candidatesOf;
using test::expectWithinBins;
using test::kDegree;
using test::patchOf;
using test::pointOn;
using test::shapesOf;
using test::SurfacePoint;

TEST(SphereVotes, FindRadiusBetweenTwoBins) {
  Random random(21);
  // Bins of 10 mm: centres at 0.095 and 0.105.
  for (const double radius : {0.0975, 0.1, 0.1033}) {
    const Sphere sphere = {Vec3(0.0, 0.0, 1.0), radius};
    test::expectExact(shapesOf<Sphere>(candidatesOf(patchOf(sphere, 300, random), 2.0)), sphere);
  }
}

TEST(SphereVotes, WithoutBinAveragesGiveTheBinCentre) {
  Random random(22);
  Params params = presetParams("paper");
  params.average_bins = false;
  const List<Candidate> candidates =
      candidatesOf(patchOf(Sphere{Vec3(0.0, 0.0, 1.0), 0.1033}, 300, random), 2.0, params);
  for (const Sphere& found : shapesOf<Sphere>(candidates)) EXPECT_NEAR(found.radius, 0.105, 1e-9);
  EXPECT_FALSE(shapesOf<Sphere>(candidates).empty());
}

TEST(CylinderVotes, WithoutBinAveragesGiveBinCentres) {
  Random random(30);
  Params params = presetParams("paper");
  params.average_bins = false;
  params.detect_cones = false;
  const Cylinder cylinder = {Vec3(0.0, 0.0, 1.2), test::randomDirection(random), 0.1033};
  const std::vector<SurfacePoint> points = patchOf(cylinder, 400, -0.2, 0.2, random);
  const Samples samples = test::samplesOf(points);
  const List<Candidate> candidates = candidatesOf(points, 2.0, params);
  ASSERT_FALSE(shapesOf<Cylinder>(candidates).empty());
  for (const Cylinder& found : shapesOf<Cylinder>(candidates)) EXPECT_NEAR(found.radius, 0.105, 1e-9);
  // phi of the first candidate, which is that of the first sample, is a multiple of the 10 deg bin.
  const kernels::Reference reference = referenceAt(samples, 0);
  const Vec3 y(reference.tangent_y.x, reference.tangent_y.y, reference.tangent_y.z);
  const Vec3 z(reference.tangent_z.x, reference.tangent_z.y, reference.tangent_z.z);
  const Vec3 axis = shapesOf<Cylinder>(candidates)[0].axis;
  ASSERT_LT((candidates[0].point - points[0].point).norm(), 1e-6);
  const double bins = std::atan2(axis.dot(z), axis.dot(y)) / (10.0 * kDegree);
  EXPECT_NEAR(bins, std::round(bins), 1e-4);
}

TEST(CylinderVotes, FindRadiusAndAxisBetweenBins) {
  Random random(23);
  Params params = presetParams("paper");
  params.detect_cones = false;
  for (int trial = 0; trial < 5; ++trial) {
    const Cylinder cylinder = {Vec3(0.0, 0.0, 1.2), test::randomDirection(random), random.uniform(0.06, 0.2)};
    const List<Candidate> candidates = candidatesOf(patchOf(cylinder, 400, -0.2, 0.2, random), 2.0, params);
    expectWithinBins(shapesOf<Cylinder>(candidates), cylinder);
  }
}

TEST(CylinderVotes, AverageAcrossTheWrapOfPhi) {
  // A reference whose tangent_y is a hair's breadth from the axis: the votes fall on both sides of phi = 0.
  for (const double offset : {-0.02, 0.0, 0.02}) {
    const Vec3 normal = Vec3(0.0, 0.0, -1.0);
    const Vec3 tangent = normal.unitOrthogonal();
    const Cylinder cylinder = {Vec3(0.0, 0.0, 1.0), Eigen::AngleAxisd(offset, normal) * tangent, 0.1};
    std::vector<SurfacePoint> points = {{Vec3(0.0, 0.0, 0.9), normal}};
    for (double angle = -1.2; angle < 1.2; angle += 0.05) {
      const Vec3 out = Eigen::AngleAxisd(angle, cylinder.axis) * normal;
      for (const double height : {-0.1, 0.0, 0.1}) {
        points.push_back({cylinder.point + height * cylinder.axis + 0.1 * out, out});
      }
    }
    Params params = presetParams("paper");
    params.references = 1;
    params.detect_cones = false;
    const std::vector<Cylinder> found = shapesOf<Cylinder>(candidatesOf(points, 2.0, params));
    ASSERT_EQ(found.size(), 1u) << offset;
    EXPECT_LT(test::lineAngle(found[0].axis, cylinder.axis), 0.1 * kDegree) << offset;
  }
}

TEST(ConeVotes, FindApexAxisAndAngle) {
  Random random(24);
  Params params = presetParams("paper");
  params.detect_cylinders = params.detect_spheres = false;
  for (int trial = 0; trial < 6; ++trial) {
    const Cone cone = {Vec3(0.0, 0.0, 1.0), test::randomDirectionAway(random), random.uniform(15.0, 45.0) * kDegree};
    const List<Candidate> candidates = candidatesOf(patchOf(cone, 500, 0.05, 0.3, random), 2.0, params);
    SCOPED_TRACE(trial);
    expectWithinBins(shapesOf<Cone>(candidates), cone);
  }
}

TEST(ConeRecovery, GivesBackEveryConeFromItsVotingParameters) {
  Random random(25);
  for (int trial = 0; trial < 300; ++trial) {
    const Cone cone = {test::randomPoint(random), test::randomDirection(random), random.uniform(0.02, 1.5)};
    const double height = random.uniform(0.05, 1.0);
    const SurfacePoint p = pointOn(cone, height, random.uniform(0.0, 6.0));
    const double axis_distance = height * std::tan(cone.half_angle) / std::cos(cone.half_angle);
    const Vec3 unsigned_axis = trial % 2 ? cone.axis : Vec3(-cone.axis);
    const std::optional<Cone> found = coneFromVotes(p.point, p.normal, unsigned_axis, axis_distance);
    ASSERT_TRUE(found);
    EXPECT_LT((found->apex - cone.apex).norm(), 1e-6);
    EXPECT_LT((found->axis - cone.axis).norm(), 1e-9);
    EXPECT_NEAR(found->half_angle, cone.half_angle, 1e-9);
  }
}

TEST(ConeRecovery, RefusesTheCylinderAndThePlane) {
  EXPECT_FALSE(coneFromVotes(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), 0.1));  // apex at infinity
  EXPECT_FALSE(coneFromVotes(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitX(), 0.1));  // half angle pi / 2
}

TEST(ConeVotes, NearACylinderStayWithinTheAngleLimit) {
  Random random(26);
  Params params = presetParams("paper");
  params.min_half_angle_deg = 5.0;
  const Cylinder cylinder = {Vec3(0.0, 0.0, 1.2), Vec3(0.2, 1.0, 0.1).normalized(), 0.1};
  const List<Candidate> candidates = candidatesOf(patchOf(cylinder, 400, -0.2, 0.2, random), 2.0, params);
  for (const Cone& cone : shapesOf<Cone>(candidates)) EXPECT_GE(cone.half_angle, params.min_half_angle_deg * kDegree);
  // The exact axis lies in the tangent plane, where the cone has no apex: the cylinder is what is left.
  EXPECT_GT(shapesOf<Cylinder>(candidates).size(), 300u);
}

TEST(AxisThroughTheReference, GivesNoConeAndNoNan) {
  // Points of a disc seen along its normal: every axis through the reference, C2 = C3 = 0.
  const Plane plane = {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  std::vector<SurfacePoint> points = {pointOn(plane, 0.0, 0.0)};
  for (int i = 0; i < 40; ++i) {
    SurfacePoint p = pointOn(plane, 0.1 * std::cos(i), 0.1 * std::sin(i));
    p.normal = (p.normal + 0.4 * (p.point - points[0].point).cross(p.normal) / 0.1).normalized();  // twisted, d.n_i = 0
    points.push_back(p);
  }
  Params params = presetParams("paper");
  params.references = 1;
  for (const Candidate& candidate : candidatesOf(points, 2.0, params)) {
    EXPECT_NE(kindOf(candidate.shape), Kind::cone);
    EXPECT_TRUE(project(candidate.shape, Vec3::Zero()).allFinite());
  }
}

TEST(PairVoting, TakesAThirdOfTheSamplesForReferencesWhereShapesAreVerified) {
  Random random(31);
  const Samples samples = test::samplesOf(patchOf(Sphere{Vec3(0.0, 0.0, 1.0), 0.1}, 900, random));
  Params params;
  params.references = 512;
  PairVoting verified(params);
  verified.begin(samples, 1.0);
  EXPECT_EQ(verified.references(), 300u);
  params.verify = false;
  PairVoting by_votes(params);
  by_votes.begin(samples, 1.0);
  EXPECT_EQ(by_votes.references(), 512u);
}

TEST(PairVoting, NeedsMoreThanMinVotes) {
  Random random(27);
  const Sphere sphere = {Vec3(0.0, 0.0, 1.0), 0.1};
  EXPECT_TRUE(candidatesOf(patchOf(sphere, 6, random), 2.0).empty());
  EXPECT_FALSE(candidatesOf(patchOf(sphere, 60, random), 2.0).empty());
}

TEST(PairVoting, ProposesPlanesOnAPlane) {
  Random random(28);
  const Plane plane = {Vec3(0.0, 0.2, 1.0), Vec3(0.1, -0.9, -0.3).normalized()};
  const List<Candidate> candidates = candidatesOf(patchOf(plane, 200, 0.2, random), 2.0);
  EXPECT_GT(shapesOf<Plane>(candidates).size(), 150u);
  EXPECT_EQ(shapesOf<Plane>(candidates).size(), candidates.size());
}

TEST(PairVoting, TakesTheNearestPairsWhereManyAreWithinReach) {
  std::vector<SurfacePoint> row;
  for (int i = 0; i < 1024; ++i) row.push_back(pointOn(Plane{Vec3::UnitZ(), -Vec3::UnitZ()}, 2e-4 * i, 0.0));
  const Samples samples = test::samplesOf(row);
  Params params;
  const auto votesInTheMiddle = [&samples](const Params& params, bool all = false) {
    PairVoting voting(params);
    voting.pairWithAll(all);
    voting.begin(samples, 2.0);
    List<Candidate> candidates;
    voting.voteAt(512, candidates);
    return candidates.size() == 1 ? candidates[0].votes : 0.0;
  };
  // 16 boxes of 16 samples at most, and half of them at least: the reach never shrinks to less of itself. Float
  // rounding of the angles costs a few votes.
  EXPECT_LE(votesInTheMiddle(params), 256.0);
  EXPECT_GE(votesInTheMiddle(params), 0.95 * 128.0);
  EXPECT_NEAR(votesInTheMiddle(params, true), 1023.0, 0.05 * 1023.0);
  params.verify = false;
  EXPECT_NEAR(votesInTheMiddle(params), 1023.0, 0.05 * 1023.0);
}

TEST(PairVoting, SkipsSamplesWithoutNormals) {
  std::vector<SurfacePoint> points;
  Random random(29);
  for (SurfacePoint p : patchOf(Sphere{Vec3(0.0, 0.0, 1.0), 0.1}, 100, random)) {
    p.normal.setConstant(std::numeric_limits<double>::quiet_NaN());
    points.push_back(p);
  }
  EXPECT_TRUE(candidatesOf(points, 2.0).empty());
}

}  // namespace
}  // namespace primitect::voting_test
