// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1: who votes for what, and how much mass arrives.
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "core/accumulators.h"
#include "test/support/exact_shapes.h"

namespace primitect {
namespace {

using test::pointOn;
using test::SurfacePoint;

constexpr double kDegree = M_PI / 180.0;

/// Votes of one reference with given pairs, in a scene of diameter 5 m (R up to 1 m, pairs up to 1 m apart).
class Ballot {
 public:
  explicit Ballot(const Params& params = presetParams("paper")) : params_(params) {}

  void cast(const SurfacePoint& reference, const std::vector<SurfacePoint>& others) {
    const double diameter = 5.0;
    const int phi_bins = 18;
    plane = 0.0f;
    sphere.assign(40, 0.0f);
    cylinder.assign(40 * phi_bins, 0.0f);
    cone.assign(40 * static_cast<std::size_t>(ball_.binCount()), 0.0f);
    kernels::Accumulators bins = {&plane,   sphere.data(),    cylinder.data(), cone.data(), 40,
                                  phi_bins, ball_.binCount(), 40.0f,           ball_.view()};
    const Samples samples = test::samplesOf(others);
    kernels::vote(referenceAt(test::samplesOf({reference}), 0), samples.view(), votingRules(params_, diameter), bins);
  }

  static double mass(const std::vector<float>& votes) { return std::accumulate(votes.begin(), votes.end(), 0.0); }

  float plane = 0.0f;
  std::vector<float> sphere, cylinder, cone;

 private:
  Params params_;
  AxisBall ball_{10.0 * kDegree};
};

const Sphere kSphere = {Vec3(0.1, -0.2, 1.0), 0.3};
const Cylinder kCylinder = {Vec3(0.0, 0.1, 1.0), Vec3(0.1, 0.9, 0.2).normalized(), 0.3};
const Cone kCone = {Vec3(0.0, -0.2, 1.0), Vec3(0.0, 1.0, 0.1).normalized(), 25.0 * kDegree};

TEST(Votes, OfAPlanePairGoToThePlaneAlone) {
  // Along a coordinate axis, so that rounding makes no pair look concave.
  const Plane plane = {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  Ballot ballot;
  ballot.cast(pointOn(plane, 0.0, 0.0), {pointOn(plane, 0.1, 0.2), pointOn(plane, -0.3, 0.1)});
  // Exact but for float rounding of the angles, which costs up to 1e-3 rad of the 10 deg.
  EXPECT_NEAR(ballot.plane, 2.0f, 0.05f);
  EXPECT_EQ(Ballot::mass(ballot.sphere) + Ballot::mass(ballot.cylinder) + Ballot::mass(ballot.cone), 0.0);
}

TEST(Votes, OfASpherePairGoToSphereAndCylinderWithMassOne) {
  Ballot ballot;
  ballot.cast(pointOn(kSphere, Vec3(0.0, 0.0, -1.0)), {pointOn(kSphere, Vec3(0.6, 0.0, -0.8))});
  EXPECT_EQ(ballot.plane, 0.0f);
  EXPECT_NEAR(Ballot::mass(ballot.sphere), 1.0, 0.02);
  EXPECT_NEAR(Ballot::mass(ballot.cylinder), 1.0, 0.02);
}

TEST(Votes, OfACylinderPairGoToCylinderAndConeWithMassOne) {
  Ballot ballot;
  ballot.cast(pointOn(kCylinder, 0.0, 0.0), {pointOn(kCylinder, 0.4, 0.8)});
  EXPECT_EQ(Ballot::mass(ballot.sphere), 0.0);
  EXPECT_NEAR(Ballot::mass(ballot.cylinder), 1.0, 0.02);
  EXPECT_NEAR(Ballot::mass(ballot.cone), 1.0, 1e-4);
}

TEST(Votes, OfAConePairGoToTheConeAloneWithMassOne) {
  Ballot ballot;
  ballot.cast(pointOn(kCone, 0.3, 0.0), {pointOn(kCone, 0.8, 1.2)});
  EXPECT_EQ(ballot.plane, 0.0f);
  EXPECT_EQ(Ballot::mass(ballot.sphere) + Ballot::mass(ballot.cylinder), 0.0);
  EXPECT_NEAR(Ballot::mass(ballot.cone), 1.0, 1e-4);
}

TEST(Votes, WithoutSpreadingFallIntoOneBinEach) {
  Params params = presetParams("paper");
  params.spread_votes = false;
  Ballot ballot(params);
  ballot.cast(pointOn(kCylinder, 0.0, 0.0), {pointOn(kCylinder, 0.4, 0.8)});
  EXPECT_EQ(std::count(ballot.cylinder.begin(), ballot.cylinder.end(), 1.0f), 1);
  EXPECT_EQ(std::count(ballot.cone.begin(), ballot.cone.end(), 1.0f), 1);
  EXPECT_EQ(Ballot::mass(ballot.cylinder), 1.0);
  EXPECT_EQ(Ballot::mass(ballot.cone), 1.0);
}

TEST(Votes, OfParallelNormalsOnACylinderGoNowhereCurved) {
  Ballot ballot;
  ballot.cast(pointOn(kCylinder, 0.0, 0.0), {pointOn(kCylinder, 0.4, 0.0)});
  EXPECT_EQ(Ballot::mass(ballot.sphere) + Ballot::mass(ballot.cylinder) + Ballot::mass(ballot.cone), 0.0);
}

TEST(Votes, OfASlightlyConcavePlanePairCountUnlessPlanesMustBeConvex) {
  const SurfacePoint reference = {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  const SurfacePoint above = {Vec3(0.2, 0.0, 0.999), Vec3(0.0, 0.0, -1.0)};
  Params params = presetParams("paper");
  Ballot strict(params);
  strict.cast(reference, {above});
  EXPECT_EQ(strict.plane, 0.0f);
  params.convex_planes = false;
  Ballot open(params);
  open.cast(reference, {above});
  EXPECT_GT(open.plane, 0.9f);
}

TEST(Votes, AreNotCastForConcavePairs) {
  SurfacePoint a = pointOn(kSphere, Vec3(0.0, 0.0, -1.0));
  SurfacePoint b = pointOn(kSphere, Vec3(0.6, 0.0, -0.8));
  a.normal = -a.normal;
  b.normal = -b.normal;
  Ballot ballot;
  ballot.cast(a, {b});
  EXPECT_EQ(Ballot::mass(ballot.sphere) + Ballot::mass(ballot.cylinder) + Ballot::mass(ballot.cone), 0.0);
}

TEST(Votes, AreNotCastBeyondThePairDistance) {
  const Plane plane = {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  Ballot ballot;
  ballot.cast(pointOn(plane, 0.0, 0.0), {pointOn(plane, 0.0, 1.01)});
  EXPECT_EQ(ballot.plane, 0.0f);
  ballot.cast(pointOn(plane, 0.0, 0.0), {pointOn(plane, 0.0, 0.99)});
  EXPECT_GT(ballot.plane, 0.9f);
}

TEST(Votes, SkipTheReferenceItselfAndMissingNormals) {
  const SurfacePoint reference = pointOn(kSphere, Vec3(0.0, 0.0, -1.0));
  SurfacePoint missing = pointOn(kSphere, Vec3(0.6, 0.0, -0.8));
  missing.normal.setConstant(std::numeric_limits<double>::quiet_NaN());
  Ballot ballot;
  ballot.cast(reference, {reference, missing});
  EXPECT_EQ(ballot.plane + Ballot::mass(ballot.sphere) + Ballot::mass(ballot.cylinder) + Ballot::mass(ballot.cone),
            0.0);
}

TEST(Votes, ForARadiusBeyondTheLastBinAreNotCast) {
  const Sphere large = {Vec3(0.0, 0.0, 2.0), 1.2};
  Ballot ballot;
  ballot.cast(pointOn(large, Vec3(0.0, 0.0, -1.0)), {pointOn(large, Vec3(std::sin(0.5), 0.0, -std::cos(0.5)))});
  EXPECT_EQ(Ballot::mass(ballot.sphere) + Ballot::mass(ballot.cylinder) + Ballot::mass(ballot.cone), 0.0);
}

TEST(Votes, FollowTheSwitchOfEachKind) {
  const SurfacePoint reference = pointOn(kSphere, Vec3(0.0, 0.0, -1.0));
  const SurfacePoint other = pointOn(kSphere, Vec3(0.6, 0.1, -0.78).normalized());
  for (const char* only : {"detect_spheres", "detect_cylinders", "detect_cones"}) {
    Params params = presetParams("paper");
    for (const char* kind : {"detect_planes", "detect_spheres", "detect_cylinders", "detect_cones"}) {
      setParam(params, kind, std::string(kind) == only);
    }
    Ballot ballot(params);
    ballot.cast(reference, {other});
    EXPECT_EQ(Ballot::mass(ballot.sphere) > 0.0, params.detect_spheres) << only;
    EXPECT_EQ(Ballot::mass(ballot.cylinder) > 0.0, params.detect_cylinders) << only;
    EXPECT_EQ(Ballot::mass(ballot.cone) > 0.0, params.detect_cones) << only;
  }
}

TEST(Votes, SurviveRandomNoise) {
  Random random(9);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 2000; ++i) points.push_back({test::randomPoint(random, 0.4), test::randomDirection(random)});
  Ballot ballot;
  ballot.cast(points.front(), points);
  EXPECT_LT(Ballot::mass(ballot.cone), 2000.0);
  EXPECT_GT(Ballot::mass(ballot.cone), 0.0);
  for (const float votes : ballot.cone) EXPECT_GE(votes, 0.0f);
}

}  // namespace
}  // namespace primitect
