// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Algorithm 1: who votes for what, and how much mass arrives.
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "core/accumulators.h"
#include "test/support/exact_shapes.h"

namespace primitect::votes_test {
namespace {

using test::kDegree;
using test::pointOn;
using test::SurfacePoint;

/// Votes for one kind of curved shape: rows of 40 bins of R or s_r, and some that stay empty.
struct KindVotes {
  std::vector<float> votes;
  std::vector<int> cells;

  kernels::Bins cleared(std::size_t rows, std::size_t samples) {
    votes.assign(rows * kStride, 0.0f);
    cells.resize(4 * samples);
    return {votes.data(), cells.data(), 0, 0.0f, 0.0f, 0};
  }
  bool operator==(const KindVotes& other) const { return votes == other.votes; }

  static constexpr int kStride = 48;
};

/// Votes for curved surfaces seen from one side.
struct CurvedVotes {
  KindVotes sphere, cylinder, cone;

  kernels::CurvedBins cleared(std::size_t phi_bins, std::size_t ball_bins, std::size_t samples) {
    return {sphere.cleared(1, samples), cylinder.cleared(phi_bins, samples), cone.cleared(ball_bins, samples)};
  }
};

/// Votes of one reference with given pairs, in a scene of diameter 5 m (R up to 1 m, pairs up to 1 m apart).
class Ballot {
 public:
  explicit Ballot(const Params& params = presetParams("paper")) : rules(votingRules(params, 5.0)) {}

  void cast(const SurfacePoint& reference, const std::vector<SurfacePoint>& others) {
    cast(referenceAt(test::samplesOf({reference}), 0), others);
  }

  void cast(const kernels::Reference& reference, const std::vector<SurfacePoint>& others) {
    const int radius_bins = 40, phi_bins = 18;
    const Samples samples = test::samplesOf(others);
    kernels::Accumulators bins = {0.0f,
                                  convex.cleared(phi_bins, ball_.binCount(), others.size()),
                                  concave.cleared(phi_bins, ball_.binCount(), others.size()),
                                  radius_bins,
                                  KindVotes::kStride,
                                  phi_bins,
                                  40.0f,
                                  ball_.view()};
    kernels::vote(reference, samples.view(), rules, bins);
    plane = bins.plane;
  }

  static double mass(const KindVotes& kind) { return std::accumulate(kind.votes.begin(), kind.votes.end(), 0.0); }
  static double mass(const CurvedVotes& side) { return mass(side.sphere) + mass(side.cylinder) + mass(side.cone); }

  /// Bins with exactly one vote.
  static std::ptrdiff_t ones(const KindVotes& kind) { return std::count(kind.votes.begin(), kind.votes.end(), 1.0f); }

  kernels::VotingRules rules;
  float plane = 0.0f;
  CurvedVotes convex, concave;

 private:
  AxisBall ball_{10.0 * kDegree};
};

/// The weights that a pair should have, from its angles as eq. 1 defines them.
struct PairFeaturesOf {
  double symmetry, triangle;
  PairFeaturesOf(const SurfacePoint& r, const SurfacePoint& i) {
    const auto angle = [](const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); };
    const Vec3 d = i.point - r.point;
    const double f2 = angle(d, r.normal), f3 = angle(d, i.normal), f4 = angle(r.normal, i.normal);
    const double epsilon = 10.0 * kDegree;
    symmetry = std::max(0.0, 1.0 - std::abs(f2 + f3 - M_PI) / epsilon);
    triangle = std::max(0.0, 1.0 - std::abs(f2 - f3 - f4) / epsilon);
  }
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
  EXPECT_EQ(Ballot::mass(ballot.convex), 0.0);
}

TEST(Votes, OfASpherePairGoToSphereAndCylinderWithMassOne) {
  Ballot ballot;
  ballot.cast(pointOn(kSphere, Vec3(0.0, 0.0, -1.0)), {pointOn(kSphere, Vec3(0.6, 0.0, -0.8))});
  EXPECT_EQ(ballot.plane, 0.0f);
  EXPECT_NEAR(Ballot::mass(ballot.convex.sphere), 1.0, 0.02);
  EXPECT_NEAR(Ballot::mass(ballot.convex.cylinder), 1.0, 0.02);
}

TEST(Votes, OfACylinderPairGoToCylinderAndConeWithMassOne) {
  Ballot ballot;
  ballot.cast(pointOn(kCylinder, 0.0, 0.0), {pointOn(kCylinder, 0.4, 0.8)});
  EXPECT_EQ(Ballot::mass(ballot.convex.sphere), 0.0);
  EXPECT_NEAR(Ballot::mass(ballot.convex.cylinder), 1.0, 0.02);
  EXPECT_NEAR(Ballot::mass(ballot.convex.cone), 1.0, 1e-4);
}

TEST(Votes, OfAConePairGoToTheConeAloneWithMassOne) {
  Ballot ballot;
  ballot.cast(pointOn(kCone, 0.3, 0.0), {pointOn(kCone, 0.8, 1.2)});
  EXPECT_EQ(ballot.plane, 0.0f);
  EXPECT_EQ(Ballot::mass(ballot.convex.sphere) + Ballot::mass(ballot.convex.cylinder), 0.0);
  EXPECT_NEAR(Ballot::mass(ballot.convex.cone), 1.0, 1e-4);
}

TEST(Votes, WithoutSpreadingFallIntoOneBinEach) {
  Params params = presetParams("paper");
  params.spread_votes = false;
  Ballot ballot(params);
  ballot.cast(pointOn(kCylinder, 0.0, 0.0), {pointOn(kCylinder, 0.4, 0.8)});
  EXPECT_EQ(Ballot::ones(ballot.convex.cylinder), 1);
  EXPECT_EQ(Ballot::ones(ballot.convex.cone), 1);
  EXPECT_EQ(Ballot::mass(ballot.convex.cylinder), 1.0);
  EXPECT_EQ(Ballot::mass(ballot.convex.cone), 1.0);
}

/// The pair with the other normal turned by an angle within the plane of both normals.
SurfacePoint turned(const SurfacePoint& reference, SurfacePoint other, double angle) {
  const Vec3 axis = reference.normal.cross(other.normal).normalized();
  other.normal = Eigen::AngleAxisd(angle, axis) * other.normal;
  return other;
}

TEST(Votes, OfAPairOffByHalfOfEpsilonCountHalf) {
  // Turning n_i on a great circle of the sphere through both points adds to F3 and F4 alike: F2 + F3 - pi and
  // F2 - F3 - F4 change by the angle and by twice the angle.
  const SurfacePoint reference = pointOn(kSphere, Vec3(0.0, 0.0, -1.0));
  const SurfacePoint exact = pointOn(kSphere, Vec3(std::sin(0.6), 0.0, -std::cos(0.6)));
  const double off = 2.5 * kDegree;
  const SurfacePoint other = turned(reference, exact, off);
  const PairFeaturesOf pair(reference, other);
  Ballot ballot;
  ballot.cast(reference, {other});
  EXPECT_NEAR(Ballot::mass(ballot.convex.cylinder), pair.symmetry, 0.01);
  EXPECT_NEAR(Ballot::mass(ballot.convex.sphere), pair.symmetry * pair.triangle, 0.01);
  EXPECT_NEAR(pair.symmetry, 0.75, 0.01);
  EXPECT_LT(Ballot::mass(ballot.convex.sphere), 0.9);
}

TEST(Votes, OfATiltedPlanePairMultiplyThreeWeights) {
  const SurfacePoint reference = {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  // The other normal leans away by 5 deg: F4 = 5 deg and F3 = 85 deg, F2 = 90 deg: 0.5 * 0.5 * 1.
  const SurfacePoint leaning = {Vec3(0.2, 0.0, 1.0), Vec3(std::sin(5.0 * kDegree), 0.0, -std::cos(5.0 * kDegree))};
  Ballot ballot;
  ballot.cast(reference, {leaning});
  EXPECT_NEAR(ballot.plane, 0.25f, 0.01f);
}

TEST(Votes, SpreadTheConesAxisDistanceBetweenTwoLayers) {
  // s_r = h tan / cos; at 40 bins a metre the layers next to it share the vote by distance.
  const double height = 0.45;
  const double axis_distance = height * std::tan(kCone.half_angle) / std::cos(kCone.half_angle);
  Ballot ballot;
  ballot.cast(pointOn(kCone, height, 0.0), {pointOn(kCone, 0.8, 1.2)});
  const std::vector<float>& votes = ballot.convex.cone.votes;
  double mean = 0.0;
  for (std::size_t bin = 0; bin < votes.size(); ++bin) {
    mean += votes[bin] * (static_cast<double>(bin % KindVotes::kStride) + 0.5) / 40.0;
  }
  EXPECT_NEAR(mean, axis_distance, 1e-3);  // a layer is 25 mm
}

TEST(Votes, OfASphereWithoutSpreadingFallIntoOneBin) {
  Params params = presetParams("paper");
  params.spread_votes = false;
  const SurfacePoint reference = pointOn(kSphere, Vec3(0.0, 0.0, -1.0));
  Ballot ballot(params);
  ballot.cast(reference,
              {turned(reference, pointOn(kSphere, Vec3(std::sin(0.6), 0.0, -std::cos(0.6))), 2.0 * kDegree)});
  EXPECT_EQ(Ballot::ones(ballot.convex.sphere), 1);
  EXPECT_EQ(Ballot::mass(ballot.convex.sphere), 1.0);
}

TEST(Votes, OfParallelNormalsOnACylinderGoNowhereCurved) {
  Ballot ballot;
  ballot.cast(pointOn(kCylinder, 0.0, 0.0), {pointOn(kCylinder, 0.4, 0.0)});
  EXPECT_EQ(Ballot::mass(ballot.convex), 0.0);
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

/// What a sensor within the body sees.
SurfacePoint fromInside(const SurfacePoint& p) { return {p.point, -p.normal}; }

TEST(Votes, OfConcavePairsAreNotCastWhereConvexOnesAreAskedFor) {
  Ballot ballot;
  ballot.cast(fromInside(pointOn(kSphere, Vec3(0.0, 0.0, -1.0))), {fromInside(pointOn(kSphere, Vec3(0.6, 0.0, -0.8)))});
  EXPECT_EQ(Ballot::mass(ballot.convex) + Ballot::mass(ballot.concave), 0.0);
}

TEST(Votes, OfAConcaveSpherePairGoToConcaveSphereAndCylinderWithMassOne) {
  Ballot ballot;
  ballot.rules.concave = true;
  ballot.cast(fromInside(pointOn(kSphere, Vec3(0.0, 0.0, -1.0))), {fromInside(pointOn(kSphere, Vec3(0.6, 0.0, -0.8)))});
  EXPECT_EQ(Ballot::mass(ballot.convex), 0.0);
  EXPECT_NEAR(Ballot::mass(ballot.concave.sphere), 1.0, 0.02);
  EXPECT_NEAR(Ballot::mass(ballot.concave.cylinder), 1.0, 0.02);
}

TEST(Votes, OfAConcaveConePairGoToTheConcaveConeAloneWithMassOne) {
  Ballot ballot;
  ballot.rules.concave = true;
  ballot.cast(fromInside(pointOn(kCone, 0.3, 0.0)), {fromInside(pointOn(kCone, 0.8, 1.2))});
  EXPECT_EQ(ballot.plane + Ballot::mass(ballot.convex), 0.0);
  EXPECT_EQ(Ballot::mass(ballot.concave.sphere) + Ballot::mass(ballot.concave.cylinder), 0.0);
  EXPECT_NEAR(Ballot::mass(ballot.concave.cone), 1.0, 1e-4);
}

TEST(Votes, OfConvexPairsAreNotCastWhereConcaveOnesAreAskedFor) {
  Ballot ballot;
  ballot.rules.convex = false;
  ballot.rules.concave = true;
  ballot.cast(pointOn(kSphere, Vec3(0.0, 0.0, -1.0)), {pointOn(kSphere, Vec3(0.6, 0.0, -0.8))});
  EXPECT_EQ(Ballot::mass(ballot.convex) + Ballot::mass(ballot.concave), 0.0);
}

/// Points and normals without any order around the first, and enough parallel ones in its plane that it gets votes.
std::vector<SurfacePoint> randomPoints(Random& random) {
  std::vector<SurfacePoint> points = {{Vec3::Zero(), test::randomDirection(random)}};
  for (int i = 0; i < 4000; ++i) points.push_back({test::randomPoint(random, 0.3), test::randomDirection(random)});
  for (int i = 0; i < 400; ++i) {
    const Vec3 normal = (points.front().normal + 0.05 * test::randomDirection(random)).normalized();
    const Vec3 across = points.front().normal.cross(test::randomPoint(random, 0.3));
    points.push_back({across, normal});
  }
  return points;
}

/// Negation is exact in floating point: a surface seen from inside gets, bit for bit, the votes of its flipped one.
TEST(Votes, OfRandomPairsSeenFromInsideAreThoseOfTheFlippedPairs) {
  Random random(31);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<SurfacePoint> points = randomPoints(random);
    std::vector<SurfacePoint> turned_round;
    for (const SurfacePoint& p : points) turned_round.push_back(fromInside(p));
    const kernels::Reference reference = referenceAt(test::samplesOf(points), 0);
    Ballot outside, inside;
    inside.rules.convex = false;
    inside.rules.concave = true;
    outside.cast(reference, points);
    inside.cast(kernels::flipped(reference), turned_round);
    for (const double votes : {Ballot::mass(outside.convex.sphere), Ballot::mass(outside.convex.cylinder),
                               Ballot::mass(outside.convex.cone), static_cast<double>(outside.plane)}) {
      ASSERT_GT(votes, 0.0);
    }
    EXPECT_TRUE(inside.concave.sphere == outside.convex.sphere);
    EXPECT_TRUE(inside.concave.cylinder == outside.convex.cylinder);
    EXPECT_TRUE(inside.concave.cone == outside.convex.cone);
    EXPECT_NEAR(inside.plane, outside.plane, 1e-4 * outside.plane);  // F2 - pi / 2 is rounded elsewhere
  }
}

TEST(Votes, OfBothSidesInOnePassAreThoseOfEachAlone) {
  Random random(32);
  const std::vector<SurfacePoint> points = randomPoints(random);
  Ballot convex, concave, both;
  concave.rules.convex = false;
  concave.rules.concave = both.rules.concave = true;
  for (Ballot* ballot : {&convex, &concave, &both}) ballot->cast(points.front(), points);
  EXPECT_GT(Ballot::mass(both.concave), 0.0);
  EXPECT_TRUE(both.convex.sphere == convex.convex.sphere);
  EXPECT_TRUE(both.convex.cylinder == convex.convex.cylinder);
  EXPECT_TRUE(both.convex.cone == convex.convex.cone);
  EXPECT_TRUE(both.concave.sphere == concave.concave.sphere);
  EXPECT_TRUE(both.concave.cylinder == concave.concave.cylinder);
  EXPECT_TRUE(both.concave.cone == concave.concave.cone);
  // A plane has no sides: a pair on either one counts.
  EXPECT_NEAR(both.plane, convex.plane + concave.plane, 1e-4 * both.plane);
}

TEST(Flipping, TurnsTheNormalsAndTheFeaturesWithThem) {
  Random random(33);
  for (int trial = 0; trial < 1000; ++trial) {
    const kernels::OrientedPoint a = test::toKernel({test::randomPoint(random), test::randomDirection(random)});
    const kernels::OrientedPoint b = test::toKernel({test::randomPoint(random), test::randomDirection(random)});
    const kernels::PairFeatures c = kernels::pairFeatures(a, b);
    const kernels::PairFeatures turned_round = kernels::pairFeatures(kernels::flipped(a), kernels::flipped(b));
    EXPECT_EQ(turned_round.c1, kernels::flipped(c).c1);
    EXPECT_EQ(turned_round.c2, kernels::flipped(c).c2);
    EXPECT_EQ(turned_round.c3, kernels::flipped(c).c3);
    EXPECT_EQ(turned_round.c4, kernels::flipped(c).c4);
    EXPECT_FALSE(kernels::isConvex(c) && kernels::isConvex(turned_round));
  }
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
  EXPECT_EQ(ballot.plane + Ballot::mass(ballot.convex), 0.0);
}

TEST(Votes, ForARadiusBeyondTheLastBinAreNotCast) {
  const Sphere large = {Vec3(0.0, 0.0, 2.0), 1.2};
  Ballot ballot;
  ballot.cast(pointOn(large, Vec3(0.0, 0.0, -1.0)), {pointOn(large, Vec3(std::sin(0.5), 0.0, -std::cos(0.5)))});
  EXPECT_EQ(Ballot::mass(ballot.convex), 0.0);
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
    EXPECT_EQ(Ballot::mass(ballot.convex.sphere) > 0.0, params.detect_spheres) << only;
    EXPECT_EQ(Ballot::mass(ballot.convex.cylinder) > 0.0, params.detect_cylinders) << only;
    EXPECT_EQ(Ballot::mass(ballot.convex.cone) > 0.0, params.detect_cones) << only;
  }
}

TEST(Votes, GoToPlanesOnlyWhenTheseAreOn) {
  const SurfacePoint reference = {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  const SurfacePoint other = {Vec3(0.2, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  Params params = presetParams("paper");
  params.detect_spheres = params.detect_cylinders = params.detect_cones = false;
  Ballot planes_alone(params);
  planes_alone.cast(reference, {other});
  EXPECT_GT(planes_alone.plane, 0.9f);
  params.detect_planes = false;
  Ballot none(params);
  none.cast(reference, {other});
  EXPECT_EQ(none.plane, 0.0f);
}

TEST(Votes, SurviveRandomNoise) {
  Random random(9);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 2000; ++i) points.push_back({test::randomPoint(random, 0.4), test::randomDirection(random)});
  Ballot ballot;
  ballot.cast(points.front(), points);
  EXPECT_LT(Ballot::mass(ballot.convex.cone), 2000.0);
  EXPECT_GT(Ballot::mass(ballot.convex.cone), 0.0);
  for (const float votes : ballot.convex.cone.votes) EXPECT_GE(votes, 0.0f);
}

}  // namespace
}  // namespace primitect::votes_test
