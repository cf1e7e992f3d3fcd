// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The kinds compete for the samples around a candidate.
#include "core/proposal.h"

#include <gtest/gtest.h>

#include "test/support/hypotheses.h"

namespace primitect::proposal_test {
namespace {

using test::kDegree;
using test::kNoise;
using test::kNoiseModel;
using test::measured;
using test::patchOf;
using test::proposalAt;
using test::samplesWith;
using test::SurfacePoint;

constexpr double kTurn = 0.08;  // rad, of normals

const Cylinder kCan = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
const Sphere kBall = {Vec3(0, 0, 1), 0.08};
const Cone kHat = {Vec3(0, -0.1, 1), Vec3(0, 1, 0), 25 * kDegree};
const Plane kWall = {Vec3(0, 0, 1), Vec3(0, 0, -1)};

/// Patches of about 0.2 m: nothing is out of reach.
ProposalRules rulesOf(const Params& params) { return {kNoiseModel, {params, 0.4}, 3.0, 0.3}; }

struct Proposed {
  List<Hypothesis> pool;
  Refusals refusals;

  /// The pool holds one of this kind and none of the others.
  const Hypothesis* only(Kind kind) const {
    return pool.size() == 1 && kindOf(pool[0].shape) == kind ? &pool[0] : nullptr;
  }
};

Proposed proposed(const Samples& samples, const List<Candidate>& candidates, const ProposalRules& rules) {
  SampleGraph graph;
  graph.build(samples);
  Proposed result;
  Proposer proposer;
  proposer.begin(HeldGains(samples.size(), 0.0f));
  proposer.propose(samples, graph, candidates, rules, result.pool, result.refusals);
  return result;
}

Proposed proposed(const Samples& samples, const List<Candidate>& candidates, const Params& params = Params()) {
  return proposed(samples, candidates, rulesOf(params));
}

Samples noisy(const std::vector<SurfacePoint>& points, std::uint64_t seed) {
  Random random(seed);
  return test::noisySamples(points, kTurn, random);
}

/// 400 samples of the can; the one that faces the sensor most is the reference of what is proposed.
Samples samplesOfCan() {
  Random random(71);
  return noisy(patchOf(kCan, 400, -0.1, 0.1, random), 1);
}
std::uint32_t nearestTo(const Samples& samples, const Vec3& p) {
  std::uint32_t nearest = 0;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if ((samples.point(i) - p).norm() < (samples.point(nearest) - p).norm()) nearest = i;
  }
  return nearest;
}

TEST(Proposal, OfAPlaneOnACylinderBecomesTheCylinder) {
  const Samples samples = samplesOfCan();
  const Plane tangent = {Vec3(0, 0, 0.95), Vec3(0, 0, -1)};
  const Proposed result = proposed(samples, {proposalAt(tangent, samples, nearestTo(samples, tangent.point))});
  const Hypothesis* found = result.only(Kind::cylinder);
  ASSERT_TRUE(found) << result.pool.size();
  // It has grown: sigma / sqrt(400), times about 4 as half a turn is seen at most; three of these.
  EXPECT_NEAR(std::get<Cylinder>(found->shape).radius, kCan.radius, 3.0 * 4.0 * kNoise / 20.0);
  EXPECT_LT(test::lineAngle(std::get<Cylinder>(found->shape).axis, kCan.axis), 1.0 * kDegree);
  EXPECT_GT(test::inlierCount(*found), 380u);
}

TEST(Proposal, OfAWrongRadiusIsFittedToAllItsSamples) {
  const Samples samples = samplesOfCan();
  const Cylinder wrong = {Vec3(0, 0, 1.006), Vec3(0.08, -1, 0).normalized(), 0.054};
  const Proposed result = proposed(samples, {proposalAt(wrong, samples, nearestTo(samples, Vec3(0, 0, 0.95)))});
  const Hypothesis* found = result.only(Kind::cylinder);
  ASSERT_TRUE(found) << result.pool.size();
  EXPECT_NEAR(std::get<Cylinder>(found->shape).radius, kCan.radius, 3.0 * 4.0 * kNoise / 20.0);
}

TEST(Proposal, KeepsEveryKindOnItsOwnPoints) {
  Random random(73);
  const std::vector<std::pair<Shape, std::vector<SurfacePoint>>> cases = {
      {kWall, patchOf(kWall, 300, 0.1, random)},
      {kBall, patchOf(kBall, 300, random)},
      {kCan, patchOf(kCan, 300, -0.1, 0.1, random)},
      {kHat, patchOf(kHat, 300, 0.05, 0.2, random)}};
  for (const auto& [shape, points] : cases) {
    const Samples samples = noisy(points, 3);
    const Proposed result = proposed(samples, {proposalAt(shape, samples, 0)});
    EXPECT_TRUE(result.only(kindOf(shape))) << kindName(kindOf(shape));
  }
}

TEST(Proposal, FindsTheInsideOfABallIfThatIsWanted) {
  Random random(74);
  Params params;
  params.convexity = "both";
  const Samples samples = noisy(test::bowlOf(kBall, 300, random), 4);
  const Proposed inside = proposed(samples, {proposalAt(kBall, samples, 0, true)}, params);
  ASSERT_TRUE(inside.only(Kind::sphere));
  EXPECT_TRUE(inside.pool[0].concave);
  EXPECT_NEAR(std::get<Sphere>(inside.pool[0].shape).radius, kBall.radius, kNoise);
}

/// The bottom of a wide bowl; reach: tangent of half the angle that it is seen under from the bowl's middle.
std::vector<SurfacePoint> bottomOf(const Sphere& bowl, double reach, int count, Random& random) {
  std::vector<SurfacePoint> points;
  for (int k = 0; k < count; ++k) {
    const Vec3 down = Vec3{random.uniform(-reach, reach), random.uniform(-reach, reach), 1.0}.normalized();
    points.push_back({bowl.center + bowl.radius * down, -down});
  }
  return points;
}

TEST(Proposal, OfAPlaneOnTheBottomOfABowlMayBecomeTheBowlIfThatIsWanted) {
  constexpr int kDraws = 20, kFewest = 10;  // of a hundred draws 79 did
  const Sphere bowl = {Vec3(0, 0, 0.7), 0.3};
  const Plane tangent = {Vec3(0, 0, 1.0), Vec3(0, 0, -1)};
  int bowls = 0;
  for (int seed = 1; seed <= kDraws; ++seed) {
    Random random(seed);
    const Samples samples = noisy(bottomOf(bowl, 0.2, 3000, random), seed);
    const List<Candidate> proposals = {proposalAt(tangent, samples, nearestTo(samples, tangent.point))};
    Params params;
    params.convexity = "concave";
    bowls += proposed(samples, proposals, params).only(Kind::sphere) ? 1 : 0;
    params.convexity = "convex";
    EXPECT_TRUE(proposed(samples, proposals, params).only(Kind::plane)) << seed;
  }
  EXPECT_GE(bowls, kFewest);
}

TEST(Proposal, IsSkippedWhereTheReferenceIsExplainedAlready) {
  Random random(74);
  const Samples samples = noisy(patchOf(kBall, 300, random), 4);
  const Sphere shifted = {Vec3(0, 0.004, 1), 0.083};
  EXPECT_EQ(proposed(samples, {proposalAt(kBall, samples, 0), proposalAt(shifted, samples, 1)}).pool.size(), 1u);
}

TEST(Proposal, ThatComesToWhatIsKnownIsNotAddedAgain) {
  Random random(79);
  const Samples samples = noisy(patchOf(kBall, 300, random), 8);
  const List<Candidate> candidates = {proposalAt(kBall, samples, 0)};
  Proposed result = proposed(samples, candidates);
  ASSERT_EQ(result.pool.size(), 1u);
  SampleGraph graph;
  graph.build(samples);
  Proposer unaware;  // of what explains the samples
  unaware.begin(HeldGains(samples.size(), 0.0f));
  unaware.propose(samples, graph, candidates, rulesOf(Params()), result.pool, result.refusals);
  EXPECT_EQ(result.pool.size(), 1u);
}

TEST(Proposal, KeepsLimitsAfterRefinement) {
  Random random(75);
  const Samples samples = noisy(patchOf(kBall, 300, random), 5);
  // The proposal is within the limit, the fit is not.
  Params params;
  params.max_radius = 0.078;
  const Proposed result = proposed(samples, {proposalAt(Sphere{Vec3(0, 0, 0.997), 0.077}, samples, 0)}, params);
  for (const Hypothesis& h : result.pool) EXPECT_NE(kindOf(h.shape), Kind::sphere);
  EXPECT_GE(result.refusals[Refusal::too_large], 1u);
}

TEST(Proposal, KeepsTheLargestRadiusThatTheVotesCanTell) {
  Random random(76);
  const Sphere large = {Vec3(0, 0, 1.4), 0.45};  // rulesOf() allows 0.4
  const Samples samples = noisy(patchOf(large, 2000, random), 6);
  const Proposed result =
      proposed(samples, {proposalAt(Sphere{Vec3(0, 0, 1.345), 0.395}, samples, nearestTo(samples, Vec3(0, 0, 0.95)))});
  for (const Hypothesis& h : result.pool) EXPECT_NE(kindOf(h.shape), Kind::sphere);
}

TEST(Proposal, DoesNotTurnAKindOnThatIsOff) {
  const Samples samples = samplesOfCan();
  const Plane tangent = {Vec3(0, 0, 0.95), Vec3(0, 0, -1)};
  const std::uint32_t reference = nearestTo(samples, tangent.point);
  ASSERT_TRUE(proposed(samples, {proposalAt(tangent, samples, reference)}).only(Kind::cylinder));
  Params params;
  params.detect_cylinders = false;
  for (const Hypothesis& h : proposed(samples, {proposalAt(tangent, samples, reference)}, params).pool) {
    EXPECT_NE(kindOf(h.shape), Kind::cylinder);
  }
}

TEST(Proposal, LeavesAFlatPatchAPlaneWhateverIsProposed) {
  Random random(77);
  const Samples samples = noisy(patchOf(kWall, 300, 0.1, random), 7);
  // Shapes that touch the wall from behind where the reference is.
  const std::uint32_t reference = nearestTo(samples, kWall.point);
  const std::vector<Shape> touching = {Sphere{Vec3(0, 0, 1.3), 0.3}, Cylinder{Vec3(0, 0, 1.2), Vec3(1, 0, 0), 0.2},
                                       Cone{Vec3(-0.2, 0, 1.0), Vec3(std::cos(0.3), 0, std::sin(0.3)), 0.3}};
  for (const Shape& shape : touching) {
    const Proposed result = proposed(samples, {proposalAt(shape, samples, reference)});
    const Hypothesis* found = result.only(Kind::plane);
    ASSERT_TRUE(found) << kindName(kindOf(shape)) << " " << result.pool.size();
    EXPECT_LT(test::lineAngle(std::get<Plane>(found->shape).normal, kWall.normal), 1.0 * kDegree);
  }
}

TEST(Proposal, LeavesNoCurvedShapeOnASmallPatchWithNoisyNormals) {
  // 30 samples over 3 cm, normals off by 9 deg: curvature cannot be told.
  int curved = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Samples samples = test::noisySamples(patchOf(kWall, 30, 0.015, random), 0.1, random);
    const Proposed result = proposed(samples, {proposalAt(Sphere{Vec3(0, 0, 1.05), 0.05}, samples, 0)});
    for (const Hypothesis& h : result.pool) curved += kindOf(h.shape) != Kind::plane;
  }
  EXPECT_EQ(curved, 0);
}

TEST(Proposal, KeepsTwoParallelDiscsApart) {
  // 12 mm apart, six standard deviations: each disc is within twice the tolerance of the other.
  constexpr double kCoarse = 0.002;
  const NoiseModel coarse = {kCoarse, 0.0, 0.5};
  const Plane front = {Vec3(0, 0, 1.0), Vec3(0, 0, -1)}, back = {Vec3(0, 0, 1.012), Vec3(0, 0, -1)};
  Random random(78);
  std::vector<SurfacePoint> points;
  while (points.size() < 600) {
    const Vec3 p = 0.1 * test::randomPoint(random);
    if (p.head<2>().norm() > 0.1) continue;
    const bool left = points.size() < 300;
    points.push_back(
        {(left ? front : back).point + Vec3(left ? p.x() - 0.105 : p.x() + 0.105, p.y(), 0), front.normal});
  }
  const Samples samples = samplesWith(coarse, measured(points, kCoarse, kTurn, random));
  SampleGraph graph;
  graph.build(samples);
  const Params params;
  List<Hypothesis> pool;
  Refusals refusals;
  Proposer proposer;
  proposer.begin(HeldGains(samples.size(), 0.0f));
  proposer.propose(samples, graph, {proposalAt(front, samples, 10), proposalAt(back, samples, 310)},
                   {coarse, {params, 0.4}, 1.0, 0.3}, pool, refusals);
  const Selection selection = selectHypotheses(samples, pool, 25);
  ASSERT_EQ(selection.chosen.size(), 2u);
  for (const std::uint32_t h : selection.chosen) {
    ASSERT_EQ(kindOf(pool[h].shape), Kind::plane);
    const Plane& plane = std::get<Plane>(pool[h].shape);
    EXPECT_LT(test::lineAngle(plane.normal, front.normal), 1.0 * kDegree);
  }
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) wrong += selection.owner[i] != selection.owner[i < 300 ? 10 : 310];
  // Beyond half way, three standard deviations: 0.3 % on either disc, and those that nobody takes.
  EXPECT_LT(wrong, 12u);
  EXPECT_NE(selection.owner[10], selection.owner[310]);
}

TEST(Proposal, DoesNotReachOverAGap) {
  // Two walls in one plane, a hand's breadth apart: what the candidate gathers is its own wall, before it grows.
  Random random(79);
  std::vector<SurfacePoint> points = patchOf(kWall, 100, 0.02, random);
  for (SurfacePoint& p : patchOf(kWall, 20, 0.01, random)) points.push_back({p.point + Vec3(0.12, 0, 0), p.normal});
  const Samples samples = noisy(points, 9);
  Params params;
  params.min_inliers = 50;
  // Of the small one, alone, there are fewer than half of the 50.
  const Proposed small = proposed(samples, {proposalAt(kWall, samples, 110)}, params);
  EXPECT_TRUE(small.pool.empty());
  EXPECT_EQ(small.refusals[Refusal::few_inliers], 1u);
  EXPECT_EQ(proposed(samples, {proposalAt(kWall, samples, 10)}, params).pool.size(), 1u);
}

TEST(Proposal, OfATubeReachesOverAGapOfADepthImageWhereEitherSideIsFlat) {
  // Two strips of a can, 20 deg wide, with 40 deg between them that a pole hides.
  Random random(87);
  const NoiseModel camera = {0.0, 0.002, 0.15};
  std::vector<SurfacePoint> points;
  for (const SurfacePoint& p : patchOf(kCan, 3000, -0.1, 0.1, random)) {
    const double angle = std::abs(std::atan2(p.point.x(), 1.0 - p.point.z())) / kDegree;
    if (angle > 20.0 && angle < 40.0) points.push_back(p);
  }
  const Samples samples = samplesWith(camera, measured(points, 0.0005, 0.03, random));
  const Params params;
  ProposalRules rules = {camera, {params, 0.4}, 1.5, 0.3};
  const Proposed found = proposed(samples, {proposalAt(kCan, samples, 0)}, rules);
  ASSERT_EQ(found.pool.size(), 2u) << "its own strip as a plane, too: the two compete";
  EXPECT_EQ(kindOf(found.pool[0].shape), Kind::cylinder);
  EXPECT_EQ(kindOf(found.pool[1].shape), Kind::plane);
  EXPECT_GT(found.pool[0].inliers, 0.9 * static_cast<double>(points.size()));
  // Points of other sensors may lie at any distance from each other.
  rules.noise = {0.002, 0.0, 0.15};
  const Proposed others = proposed(samples, {proposalAt(kCan, samples, 0)}, rules);
  ASSERT_EQ(others.pool.size(), 1u);
  EXPECT_EQ(kindOf(others.pool[0].shape), Kind::plane);
}

TEST(Proposal, CountsWhatIsRefused) {
  Random random(80);
  const Samples few = noisy(patchOf(kWall, 20, 0.1, random), 10);
  const Proposed result = proposed(few, {proposalAt(kWall, few, 0), proposalAt(kWall, few, 1)});
  EXPECT_TRUE(result.pool.empty());
  EXPECT_EQ(result.refusals[Refusal::few_inliers], 2u);
  EXPECT_EQ(result.refusals[Refusal::unlikely], 0u);
  const Samples enough = noisy(patchOf(kWall, 200, 0.1, random), 10);
  EXPECT_EQ(proposed(enough, {proposalAt(kWall, enough, 0)}).refusals[Refusal::few_inliers], 0u);
}

TEST(Proposal, IsNotTriedAThirdTimeAtTheSamePlace) {
  Random random(80);
  const Samples few = noisy(patchOf(kWall, 20, 0.1, random), 10);
  const Candidate weak = proposalAt(kWall, few, 0);
  EXPECT_EQ(proposed(few, {weak, weak, weak, weak}).refusals[Refusal::few_inliers], 2u);
  // One failure does not stand in the way of a better one.
  const Samples enough = noisy(patchOf(kWall, 200, 0.1, random), 10);
  Candidate wrong = proposalAt(kWall, enough, 0);
  std::get<Plane>(wrong.shape).normal = Vec3::UnitX();
  EXPECT_EQ(proposed(enough, {wrong, proposalAt(kWall, enough, 0)}).pool.size(), 1u);
}

TEST(BestOfKinds, IsNotHeldBackByABetterFitBeyondTheLimits) {
  // 60 deg of a tube that is wider than allowed: a plane explains some of it.
  Random random(82);
  std::vector<SurfacePoint> strip;
  for (const SurfacePoint& p : patchOf(kCan, 2400, -0.1, 0.1, random)) {
    if (p.normal.dot(Vec3(0, 0, -1)) > std::cos(30.0 * kDegree)) strip.push_back(p);
  }
  const Samples samples = noisy(strip, 13);
  Params params;
  params.max_radius = 0.04;
  Hypothesis hypothesis = test::hypothesisOf(kCan, samples);
  Refusals refusals;
  ASSERT_TRUE(bestOfKinds(samples, HeldGains(samples.size(), 0.0f), test::allOf(samples), rulesOf(params), hypothesis,
                          &refusals));
  EXPECT_EQ(kindOf(hypothesis.shape), Kind::plane);
  EXPECT_GE(refusals[Refusal::too_large], 1u);
}

TEST(Rival, IsNamedWhereAnotherKindIsNearlyAsGood) {
  // A cone of 3 deg over a short length is a cylinder but for a millimetre.
  Params params;
  params.min_half_angle_deg = 1.0;
  Random random(81);
  const double slight = 3.0 * kDegree;
  const Cone cone = {Vec3(0, -0.05 / std::tan(slight), 1), Vec3(0, 1, 0), slight};
  const double middle = 0.05 / std::tan(slight);
  const Samples nearly = noisy(patchOf(cone, 300, middle - 0.02, middle + 0.02, random), 11);
  const Samples can = samplesOfCan(), ball = noisy(patchOf(kBall, 300, random), 12);
  ProposalRules rules = rulesOf(params);
  const auto rivalOf = [&rules](const Shape& shape, const Samples& samples) {
    return bestRival(samples, HeldGains(samples.size(), 0.0f), test::allOf(samples), rules,
                     test::hypothesisOf(shape, samples));
  };
  ASSERT_TRUE(rivalOf(cone, nearly).kind);
  EXPECT_EQ(*rivalOf(cone, nearly).kind, Kind::cylinder);
  // One of 15 deg is not.
  const double clear = 15.0 * kDegree, wide = 0.05 / std::tan(clear);
  const Cone clear_cone = {Vec3(0, -wide, 1), Vec3(0, 1, 0), clear};
  EXPECT_FALSE(rivalOf(clear_cone, noisy(patchOf(clear_cone, 300, wide - 0.02, wide + 0.02, random), 11)).kind);
  EXPECT_FALSE(rivalOf(kBall, ball).kind);
  EXPECT_GT(rivalOf(kBall, ball).lead, 0.2);
  // In depth frames all kinds are fitted, also those that come to little: what they explain is taken off.
  const double among_promising = rivalOf(kBall, ball).lead;
  rules.noise.depth_share = 1e-4;
  EXPECT_FALSE(rivalOf(kBall, ball).kind);
  EXPECT_GT(rivalOf(kBall, ball).lead, 0.2);
  EXPECT_LT(rivalOf(kBall, ball).lead, among_promising - 0.05);
  rules.noise.depth_share = 0.0;
  // A cylinder on it has the cone for a rival; its lead is over the plane and the sphere, which are far behind.
  const Cylinder touching = {Vec3(0, 0, 1), Vec3(0, 1, 0), 0.05};
  EXPECT_EQ(rivalOf(touching, nearly).kind, Kind::cone);
  EXPECT_GT(rivalOf(touching, nearly).lead, 0.2);
  // Any cylinder is nearly a cone; it is the plane and the sphere that are far behind.
  params.detect_cones = false;
  EXPECT_FALSE(rivalOf(kCan, can).kind);
}

}  // namespace
}  // namespace primitect::proposal_test
