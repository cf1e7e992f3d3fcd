// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What shapes make of the samples near them.
#include "core/hypothesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>

#include "test/support/hypotheses.h"

namespace primitect::hypothesis_test {
namespace {

using test::hypothesisOf;
using test::kNoiseModel;
using test::pointOn;
using test::samplesWith;
using test::SurfacePoint;

constexpr double kTolerance = 3.0 * test::kNoise;

/// Seen from the origin; none passes through it, so that signs of distances are not lucky.
const Plane kPlane = {Vec3(0.1, -0.2, 1.0), Vec3(0.3, 0.2, -0.9).normalized()};
const Sphere kSphere = {Vec3(0.1, 0.0, 1.0), 0.08};
const Cylinder kCylinder = {Vec3(0.0, 0.1, 1.0), Vec3(1.0, 2.0, 0.5).normalized(), 0.05};
const Cone kCone = {Vec3(0.0, 0.1, 1.0), Vec3(1.0, -2.0, 0.5).normalized(), 0.4};

/// A point on each kind with its outward normal.
const std::vector<std::pair<Shape, SurfacePoint>> kPoints = {{kPlane, pointOn(kPlane, 0.1, 0.2)},
                                                             {kSphere, pointOn(kSphere, Vec3(1, 2, -2) / 3.0)},
                                                             {kCylinder, pointOn(kCylinder, 0.1, 2.0)},
                                                             {kCone, pointOn(kCone, 0.1, 2.0)}};

/// The surface point moved along its normal (m), its normal then turned (rad) about some axis across it.
SurfacePoint strayed(const SurfacePoint& p, double distance, double angle) {
  const Vec3 across = p.normal.unitOrthogonal();
  return {p.point + distance * p.normal, std::cos(angle) * p.normal + std::sin(angle) * across};
}

/// The gain of a lone sample; nothing when the shape does not look at it.
std::optional<double> gainOf(const Shape& shape, const SurfacePoint& p, bool concave = false,
                             const NoiseModel& noise = kNoiseModel) {
  const Hypothesis hypothesis = hypothesisOf(shape, samplesWith(noise, {p}), concave);
  if (hypothesis.support.empty()) return std::nullopt;
  return hypothesis.support[0].gain;
}

// Float holds points of 1 m to 1e-7, 3e-5 of the tolerance.
constexpr double kRounding = 1e-3;

/// Samples of a first draw, and of a later one.
Samples drawn(const std::vector<SurfacePoint>& first, const std::vector<SurfacePoint>& later) {
  Samples samples;
  samples.append(samplesWith(kNoiseModel, first));
  samples.append(samplesWith(kNoiseModel, later));
  return samples;
}

/// As many points on the plane, and on one so near that they speak against it.
std::vector<SurfacePoint> onAndBeside(int on, int beside, double noise) {
  Random random(17);
  const Plane near = {kPlane.point + noise * kPlane.normal, kPlane.normal};
  return test::together({test::patchOf(kPlane, on, 0.2, random), test::patchOf(near, beside, 0.2, random)});
}

TEST(Score, OfALargePlaneIsNotSpokenAgainstByDrawsThatLeftItOut) {
  const std::vector<SurfacePoint> on = onAndBeside(300, 0, 0.0), beside = onAndBeside(0, 600, 4.0 * test::kNoise);
  const double alone = hypothesisOf(kPlane, samplesWith(kNoiseModel, on)).score;
  EXPECT_DOUBLE_EQ(hypothesisOf(kPlane, drawn(on, beside)).score, alone);
  // In one draw they are as likely to be on it as beside it.
  EXPECT_LT(hypothesisOf(kPlane, drawn(test::together({on, beside}), {})).score, alone - 100.0);
}

TEST(Score, OfAPlaneThatIsSmallInTheFirstDrawDoesNotGrowLargeInLaterOnes) {
  Random random(23);
  const Plane elsewhere = {Vec3(0, 0, 5), Vec3(0, 0, -1)};
  const auto first = test::together({onAndBeside(30, 0, 0.0), test::patchOf(elsewhere, 600, 0.2, random)});
  // The later draw has more of it than 8 % of the first one, and then twice as many that speak against it.
  const auto on = onAndBeside(192, 0, 0.0), beside = onAndBeside(0, 384, 4.0 * test::kNoise);
  const double without = hypothesisOf(kPlane, drawn(first, on)).score;
  EXPECT_LT(hypothesisOf(kPlane, drawn(first, test::together({on, beside}))).score, without - 100.0);
}

TEST(Score, OfASmallPlaneIsSpokenAgainstByAllDraws) {
  const std::vector<SurfacePoint> beside = onAndBeside(0, 600, 4.0 * test::kNoise);
  std::vector<SurfacePoint> first = onAndBeside(30, 0, 0.0);
  const double alone = hypothesisOf(kPlane, samplesWith(kNoiseModel, first)).score;
  Random random(19);
  // Far away: the plane has less than 8 % of the first draw.
  first = test::together({first, test::patchOf(Plane{Vec3(0, 0, 5), Vec3(0, 0, -1)}, 600, 0.2, random)});
  EXPECT_LT(hypothesisOf(kPlane, drawn(first, beside)).score, alone - 100.0);
}

TEST(Score, KeepsTheGainsThatAnEvaluationWouldFind) {
  Random random(29);
  const Plane elsewhere = {Vec3(0, 0, 5), Vec3(0, 0, -1)};
  // More than one block near, and blocks that are not.
  const auto on = test::patchOf(kSphere, 150, random);
  const Samples samples = samplesWith(kNoiseModel, test::together({test::patchOf(elsewhere, 100, 0.2, random), on}));
  HeldGains held(samples.size(), 0.0f);
  std::fill(held.begin() + 100, held.begin() + 130, 0.9f);
  NearGains near;
  for (const Shape& shape : {Shape(elsewhere), Shape(kSphere)}) {  // what was near before is forgotten
    Hypothesis evaluated, scored;
    evaluated.shape = scored.shape = shape;
    evaluate(samples, held, 1.0, evaluated);
    score(samples, held, 1.0, scored, near);
    fillSupport(samples, near, scored);
    EXPECT_EQ(scored.score, evaluated.score);
    EXPECT_EQ(scored.inliers, evaluated.inliers);
    EXPECT_EQ(scored.blocks, evaluated.blocks);
    ASSERT_EQ(scored.support.size(), evaluated.support.size());
    ASSERT_GT(scored.support.size(), 90u);
    for (std::size_t k = 0; k < scored.support.size(); ++k) {
      ASSERT_EQ(scored.support[k].sample, evaluated.support[k].sample);
      ASSERT_EQ(scored.support[k].gain, evaluated.support[k].gain);
    }
  }
}

TEST(Gain, IsOneOnTheSurfaceWithItsNormal) {
  for (const auto& [shape, p] : kPoints) {
    ASSERT_TRUE(gainOf(shape, p)) << kindName(kindOf(shape));
    EXPECT_NEAR(*gainOf(shape, p), 1.0, kRounding) << kindName(kindOf(shape));
  }
}

TEST(Gain, FallsWithTheSquareOfTheDistanceOnEitherSide) {
  for (const auto& [shape, p] : kPoints) {
    for (const double share : {-0.9, -0.5, 0.3, 0.7}) {
      const std::optional<double> gain = gainOf(shape, strayed(p, share * kTolerance, 0.0));
      ASSERT_TRUE(gain) << kindName(kindOf(shape));
      EXPECT_NEAR(*gain, 1.0 - share * share, kRounding) << kindName(kindOf(shape)) << " " << share;
    }
  }
}

TEST(Gain, FallsWithTheAngle) {
  for (const auto& [shape, p] : kPoints) {
    double last = 1.0;
    for (const double share : {0.3, 0.6, 0.9}) {
      const std::optional<double> gain = gainOf(shape, strayed(p, 0.0, share * kNoiseModel.angle));
      ASSERT_TRUE(gain) << kindName(kindOf(shape));
      EXPECT_LT(*gain, last - 0.05) << kindName(kindOf(shape)) << " " << share;
      EXPECT_GT(*gain, 0.0) << kindName(kindOf(shape)) << " " << share;
      last = *gain;
    }
  }
}

TEST(Gain, IsNegativeBetweenOneAndTwoTolerances) {
  for (const auto& [shape, p] : kPoints) {
    for (const double share : {-1.9, -1.05, 1.05, 1.5, 1.9}) {
      const std::optional<double> gain = gainOf(shape, strayed(p, share * kTolerance, 0.0));
      ASSERT_TRUE(gain) << kindName(kindOf(shape)) << " " << share;
      EXPECT_LT(*gain, 0.0) << kindName(kindOf(shape)) << " " << share;
    }
  }
}

TEST(Gain, IsNoneBeyondOneAndAHalfTolerancesInDepthFrames) {
  NoiseModel of_depth = kNoiseModel;
  of_depth.depth_share = 1e-3;  // at 1 m structured light errs by more than that
  const double tolerance = 3.0 * of_depth.at(kPoints[0].second.point);
  for (const double sign : {-1.0, 1.0}) {
    const std::optional<double> near =
        gainOf(kPlane, strayed(kPoints[0].second, sign * 1.4 * tolerance, 0.0), false, of_depth);
    ASSERT_TRUE(near);
    EXPECT_LT(*near, 0.0);
    EXPECT_FALSE(gainOf(kPlane, strayed(kPoints[0].second, sign * 1.6 * tolerance, 0.0), false, of_depth));
  }
}

TEST(Gain, IsNoneBeyondTwoTolerancesOrWithTheNormalOfAnotherSurface) {
  for (const auto& [shape, p] : kPoints) {
    EXPECT_FALSE(gainOf(shape, strayed(p, 2.05 * kTolerance, 0.0))) << kindName(kindOf(shape));
    EXPECT_FALSE(gainOf(shape, strayed(p, -2.05 * kTolerance, 0.0))) << kindName(kindOf(shape));
    EXPECT_FALSE(gainOf(shape, strayed(p, 0.0, M_PI / 3.0))) << kindName(kindOf(shape));
    EXPECT_FALSE(gainOf(shape, strayed(p, 0.0, M_PI))) << kindName(kindOf(shape));
  }
}

TEST(Gain, OfConcaveShapesIsThatOfTheOtherSide) {
  for (const auto& [shape, p] : kPoints) {
    const SurfacePoint inside = {p.point, -p.normal};
    ASSERT_TRUE(gainOf(shape, inside, true)) << kindName(kindOf(shape));
    EXPECT_NEAR(*gainOf(shape, inside, true), 1.0, kRounding);
    EXPECT_FALSE(gainOf(shape, p, true)) << kindName(kindOf(shape));
    EXPECT_FALSE(gainOf(shape, inside, false)) << kindName(kindOf(shape));
  }
}

TEST(Gain, OfACenterAnAxisOrAnApexIsNoneOrFinite) {
  for (const Vec3& normal : {Vec3(0, 0, -1), kCone.axis, Vec3(-kCone.axis)}) {
    for (const auto& [shape, point] : std::vector<std::pair<Shape, Vec3>>{
             {kSphere, kSphere.center}, {kCylinder, kCylinder.point}, {kCone, kCone.apex}}) {
      const std::optional<double> gain = gainOf(shape, {point, normal});
      EXPECT_TRUE(!gain || std::isfinite(*gain)) << kindName(kindOf(shape));
    }
  }
}

TEST(Gain, OfADepthCameraAllowsMoreFartherAway) {
  const NoiseModel camera = {0.0, 0.002, 0.5};
  const auto gainAt = [&camera](double depth) {
    return gainOf(Plane{Vec3(0, 0, depth), Vec3(0, 0, -1)}, {Vec3(0, 0, depth - 0.01), Vec3(0, 0, -1)}, false, camera);
  };
  // 10 mm are three standard deviations where the noise of structured light is 3.3 mm, at about 1.45 m.
  EXPECT_FALSE(gainAt(0.5));
  ASSERT_TRUE(gainAt(2.0));
  EXPECT_GT(*gainAt(2.0), 0.0);
}

TEST(Gain, TakesMoreNoiseOfANormalThatIsKnownToBeBad) {
  Samples samples = test::samplesOf({strayed(kPoints[0].second, 0.0, 0.45)});
  const NoiseModel sharp = {0.001, 0.0, 0.15};
  applyNoise(sharp, samples);
  EXPECT_EQ(test::inlierCount(hypothesisOf(kPlane, samples)), 0u);
  samples.normal_sigma[0] = 0.12f;  // four of these are 0.48
  applyNoise(sharp, samples);
  EXPECT_EQ(test::inlierCount(hypothesisOf(kPlane, samples)), 1u);
}

TEST(Gain, JudgesANormalWhereItIsThatOfTheSurface) {
  const Cylinder tube = {Vec3(0, 0, 1), Vec3(0, 1, 0), 0.05};
  const auto at = [&tube](double degrees) {
    return Vec3(tube.point +
                tube.radius * Vec3(std::sin(degrees * test::kDegree), 0, -std::cos(degrees * test::kDegree)));
  };
  // On the limb, with the normal of what is seen 20 deg before it.
  Samples samples = test::samplesOf({{at(80.0), normalAt(tube, at(60.0))}});
  const NoiseModel sharp = {0.001, 0.0, 0.15};
  applyNoise(sharp, samples);
  EXPECT_EQ(test::inlierCount(hypothesisOf(tube, samples)), 0u);
  samples.px[0] = static_cast<float>(at(60.0).x()), samples.pz[0] = static_cast<float>(at(60.0).z());
  EXPECT_EQ(test::inlierCount(hypothesisOf(tube, samples)), 1u);
  // The distance is still that of the point.
  samples.x[0] += 0.01f;
  applyNoise(sharp, samples);
  EXPECT_EQ(test::inlierCount(hypothesisOf(tube, samples)), 0u);
}

TEST(Evaluate, WidensTheToleranceOfAShapeThatIsNotFittedYet) {
  const Samples samples = samplesWith(kNoiseModel, {strayed(kPoints[1].second, 2.5 * kTolerance, 0.0)});
  Hypothesis hypothesis = hypothesisOf(kSphere, samples);
  EXPECT_TRUE(hypothesis.support.empty());
  evaluate(samples, HeldGains(1, 0.0f), 3.0, hypothesis);
  EXPECT_EQ(test::inlierCount(hypothesis), 1u);
}

/// 50 points on the plane, and 20 that lie 1.5 tolerances above it.
Samples fiftyAndTwenty() {
  Random random(11);
  std::vector<SurfacePoint> points = test::patchOf(kPlane, 70, 0.2, random);
  for (int k = 50; k < 70; ++k) points[k] = strayed(points[k], 1.5 * kTolerance, 0.0);
  return samplesWith(kNoiseModel, points);
}

TEST(Score, IsTheSumOfTheGainsLessThePriceOfTheInliers) {
  const Samples samples = fiftyAndTwenty();
  const Hypothesis hypothesis = hypothesisOf(kPlane, samples);
  ASSERT_EQ(hypothesis.support.size(), 70u);
  EXPECT_EQ(test::inlierCount(hypothesis), 50u);
  const double gains = std::accumulate(hypothesis.support.begin(), hypothesis.support.end(), 0.0,
                                       [](double sum, const Support& support) { return sum + support.gain; });
  EXPECT_LT(gains, 50.0 - 20.0);
  EXPECT_NEAR(hypothesis.score, gains - priceOf(Kind::plane, 50.0), 1e-4);  // sums in float
}

TEST(Score, DoesNotCountSamplesThatOthersHoldWellAgainstAShape) {
  const Samples samples = fiftyAndTwenty();
  Hypothesis hypothesis = hypothesisOf(kPlane, samples);
  const double alone = hypothesis.score;
  HeldGains held(samples.size(), 0.0f);
  for (int k = 50; k < 70; ++k) held[k] = 0.05f;  // poorly
  evaluate(samples, held, 1.0, hypothesis);
  EXPECT_NEAR(hypothesis.score, alone, 1e-4);
  for (int k = 50; k < 70; ++k) held[k] = 0.5f;
  evaluate(samples, held, 1.0, hypothesis);
  // Each took 1.5^2 - 1, at most 1.2; on the plane nothing is left but gains of 1.
  EXPECT_NEAR(hypothesis.score, 50.0 - priceOf(Kind::plane, 50.0), 50.0 * kRounding);
  EXPECT_GT(hypothesis.score, alone + 20.0);
}

TEST(Score, DoesNotCountSamplesBeyondTheReachOfAShapeAgainstIt) {
  // A block of samples on the plane, then a block 1 m away within the plane, 1.5 tolerances above it.
  std::vector<SurfacePoint> points;
  for (int k = 0; k < 64; ++k) points.push_back(pointOn(kPlane, 0.001 * k, 0.0));
  for (int k = 0; k < 64; ++k) points.push_back(strayed(pointOn(kPlane, 1.0 + 0.001 * k, 0.0), 1.5 * kTolerance, 0.0));
  const Samples samples = samplesWith(kNoiseModel, points);
  Hypothesis hypothesis = hypothesisOf(kPlane, samples);
  EXPECT_LT(hypothesis.score, 0.0);
  hypothesis.middle = points[32].point;
  hypothesis.reach = 0.05;
  evaluate(samples, HeldGains(samples.size(), 0.0f), 1.0, hypothesis);
  EXPECT_NEAR(hypothesis.score, 64.0 - priceOf(Kind::plane, 64.0), 64.0 * kRounding);
  EXPECT_EQ(hypothesis.support.size(), 64u);
}

std::size_t countedInCommon(const Hypothesis& a, const Hypothesis& b) {
  List<std::uint32_t> of_a, of_b, both;
  inliersOf(a, of_a), inliersOf(b, of_b);
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(both));
  return both.size();
}

TEST(Concerns, WhatIsExplainedNearTheOtherAndNotWhatSharesABlockAlone) {
  // One block: a plane, samples between one and two tolerances above it, and such that it is nowhere near.
  std::vector<SurfacePoint> points;
  for (const double height : {0.0, 1.5 * kTolerance, 0.1}) {
    for (int k = 0; k < 10; ++k) points.push_back({Vec3(0.01 * k, 0.0, 1.0 - height), Vec3(0, 0, -1)});
  }
  const Samples samples = samplesWith(kNoiseModel, points);
  const auto level = [&](double height) {
    return hypothesisOf(Plane{Vec3(0, 0, 1.0 - height), Vec3(0, 0, -1)}, samples);
  };
  const Hypothesis floor = level(0.0), above = level(1.5 * kTolerance), top = level(0.1);
  EXPECT_TRUE(mayOverlap(floor, top));
  EXPECT_FALSE(concerns(floor, top) || concerns(top, floor));
  // Neither explains a sample of the other, but those speak against it until they are explained.
  EXPECT_EQ(commonInliers(floor, above), 0u);
  EXPECT_TRUE(concerns(floor, above) && concerns(above, floor));
  Hypothesis silent = above;
  silence(silent);
  EXPECT_FALSE(concerns(silent, floor));
}

TEST(CommonInliers, AreThoseInBothLists) {
  // The second draw's blocks begin where the first draw's last one ended early.
  Random random(12);
  Samples samples = test::noisySamples(test::patchOf(kPlane, 150, 0.2, random), 0.2, random);
  samples.append(test::noisySamples(test::patchOf(kPlane, 333, 0.2, random), 0.2, random));
  Hypothesis plane = hypothesisOf(kPlane, samples);
  const Hypothesis tilted =
      hypothesisOf(Plane{kPlane.point, (kPlane.normal + Vec3(0.02, 0.0, 0.0)).normalized()}, samples);
  ASSERT_GT(countedInCommon(plane, tilted), 60u);
  ASSERT_LT(countedInCommon(plane, tilted), std::min(plane.inliers, tilted.inliers));
  EXPECT_EQ(commonInliers(plane, tilted), countedInCommon(plane, tilted));
  EXPECT_EQ(commonInliers(plane, plane), plane.inliers);
  List<std::uint32_t> some;
  for (std::uint32_t i = 0; i < samples.size(); i += 3) some.push_back(i);
  withhold(some, plane);
  EXPECT_EQ(commonInliers(plane, plane), plane.inliers);
  EXPECT_EQ(commonInliers(plane, tilted), countedInCommon(plane, tilted));
  silence(plane);
  EXPECT_EQ(commonInliers(plane, tilted), 0u);
}

TEST(Price, GrowsWithTheParametersOfTheKindAndWithTheInliers) {
  for (const double inliers : {0.0, 25.0, 1000.0}) {
    EXPECT_GE(priceOf(Kind::plane, inliers), 0.0);
    for (const auto& [less, more] : {std::pair(Kind::plane, Kind::sphere), std::pair(Kind::sphere, Kind::cylinder),
                                     std::pair(Kind::cylinder, Kind::cone)}) {
      EXPECT_LT(priceOf(less, inliers + 1.0), priceOf(more, inliers + 1.0));
      EXPECT_LE(priceOf(less, inliers), priceOf(less, 2.0 * inliers));
    }
    // Otherwise a perfect cone could not pay for itself.
    EXPECT_LT(priceOf(Kind::cone, std::max(inliers, 10.0)), std::max(inliers, 10.0));
  }
}

TEST(Hold, KeepsTheBestGainOfEachSampleAndNoLoss) {
  const Samples samples = fiftyAndTwenty();
  HeldGains held(samples.size(), 0.0f);
  held[0] = 2.0f;
  hold(hypothesisOf(kPlane, samples), held);
  EXPECT_EQ(held[0], 2.0f);
  EXPECT_NEAR(held[1], 1.0f, kRounding);
  EXPECT_EQ(held[60], 0.0f);
}

TEST(Withhold, TakesSamplesFromTheSupportAndTheirGainsFromTheSum) {
  const Samples samples = fiftyAndTwenty();
  Hypothesis hypothesis = hypothesisOf(kPlane, samples);
  const std::size_t before = hypothesis.inliers;
  const double sum = hypothesis.gain_sum;
  withhold({0, 1, 2}, hypothesis);
  EXPECT_EQ(hypothesis.inliers, before - 3);
  EXPECT_NEAR(hypothesis.gain_sum, sum - 3.0, 3 * kRounding);
  List<std::uint32_t> left;
  inliersOf(hypothesis, left);
  EXPECT_EQ(left.front(), 3u);
}

TEST(Score, IsTheSameWithoutTheSupport) {
  const Samples samples = fiftyAndTwenty();
  const Hypothesis whole = hypothesisOf(kPlane, samples);
  Hypothesis quick;
  quick.shape = kPlane;
  score(samples, HeldGains(samples.size(), 0.0f), 1.0, quick);
  EXPECT_EQ(quick.score, whole.score);
  EXPECT_EQ(quick.inliers, whole.inliers);
  EXPECT_EQ(quick.gain_sum, whole.gain_sum);
}

TEST(InliersAround, AreTheInliersWithinReach) {
  Random random(77);
  const Samples samples = samplesWith(kNoiseModel, test::patchOf(kPlane, 2000, 1.0, random));
  constexpr double kReach = 0.2;
  const Hypothesis all = hypothesisOf(kPlane, samples);
  List<std::uint32_t> expected, around;
  inliersOf(all, expected);
  const auto far = [&](std::uint32_t i) { return (samples.point(i) - samples.point(0)).norm() > kReach; };
  expected.erase(std::remove_if(expected.begin(), expected.end(), far), expected.end());
  inliersAround(samples.point(0), kReach, samples, HeldGains(samples.size(), 0.0f), 1.0, all, around);
  EXPECT_EQ(around, expected);
  EXPECT_GT(around.size(), 5u);
}

}  // namespace
}  // namespace primitect::hypothesis_test
