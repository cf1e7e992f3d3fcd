// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Noise of distances and normals, from the data.
#include "core/noise_measurement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test/support/hypotheses.h"

namespace primitect::noise_measurement_test {
namespace {

using test::hypothesisOf;
using test::kDegree;
using test::kNoise;
using test::measured;
using test::patchOf;
using test::proposalAt;
using test::samplesOf;
using test::samplesWith;
using test::SurfacePoint;

const Sphere kBall = {Vec3(0, 0, 1), 0.08};
const Plane kWall = {Vec3(0, 0, 1), Vec3(0, 0, -1)};

/// The largest noise that is possible, as a frame begins with it.
ProposalRules rulesBeforeMeasuring(const Params& params) {
  return {{0.01, 0.0, 30.0 * kDegree}, {params, 0.4}, 1.0, 0.3};
}

TEST(MeasuredNoise, IsThatOfDistancesAndNormals) {
  const Params params;
  for (const auto& [distance, angle] : {std::pair(0.001, 0.06), std::pair(0.002, 0.1), std::pair(0.0005, 0.04)}) {
    Random random(82);
    const Sphere ball = {Vec3(0, 0, 1), 0.2};
    const std::vector<SurfacePoint> points = measured(patchOf(ball, 1000, random), distance, angle, random);
    const ProposalRules rules = rulesBeforeMeasuring(params);
    const Samples samples = samplesWith(rules.noise, points);
    const NoiseModel noise = measureNoise(samples, {proposalAt(ball, samples, 0)}, rules).value();
    // The median of 1000 magnitudes strays by 4 %.
    EXPECT_NEAR(noise.distance, distance, 0.15 * distance);
    EXPECT_NEAR(noise.angle, 4.0 * angle, 0.15 * 4.0 * angle);
    EXPECT_EQ(noise.depth_share, 0.0);
  }
}

TEST(MeasuredNoise, TellsHowMuchMoreNormalsAreOffThanIsKnownOfThem) {
  const Params params;
  const Sphere ball = {Vec3(0, 0, 1), 0.2};
  for (const auto& [known, actual] : {std::pair(0.02f, 0.06), std::pair(0.01f, 0.05), std::pair(0.05f, 0.03)}) {
    Random random(86);
    const ProposalRules rules = rulesBeforeMeasuring(params);
    Samples samples = samplesOf(measured(patchOf(ball, 1000, random), kNoise, actual, random));
    std::fill(samples.normal_sigma.begin(), samples.normal_sigma.end(), known);
    applyNoise(rules.noise, samples);
    const NoiseModel noise = measureNoise(samples, {proposalAt(ball, samples, 0)}, rules).value();
    const double times = std::max(1.0, actual / static_cast<double>(known));
    EXPECT_NEAR(noise.normals, times, 0.15 * times) << known;
  }
}

/// Off a wall by this angle (rad), where so many times what is known of normals (.02 rad) was measured.
double gainOfNormalOff(double angle, double times) {
  NoiseModel noise = {kNoise, 0.0, 0.12};
  noise.normals = times;
  Samples samples = samplesOf({{Vec3(0, 0, 1), Vec3(std::sin(angle), 0, -std::cos(angle))}});
  samples.normal_sigma[0] = 0.02f;
  applyNoise(noise, samples);
  const Hypothesis wall = hypothesisOf(kWall, samples);
  return wall.support.empty() ? -1.0 : static_cast<double>(wall.support[0].gain);
}

TEST(MeasuredNoise, IsToleratedOfNormalsUpToSixteenDegrees) {
  EXPECT_LT(gainOfNormalOff(0.2, 1.0), 0.0);
  EXPECT_GT(gainOfNormalOff(0.2, 3.0), 0.0);  // .24 rad are tolerated
  EXPECT_GT(gainOfNormalOff(0.1, 1.0), 0.0);
  EXPECT_GT(gainOfNormalOff(0.3, 6.0), 0.0);  // .28, not .48
  EXPECT_LT(gainOfNormalOff(0.35, 6.0), 0.0);
}

TEST(MeasuredNoise, ComesFromWhatFitsBestWhenOtherCandidatesAreNoShapes) {
  const Params params;
  Random random(83);
  const Sphere ball = {Vec3(0, 0, 1), 0.2};
  std::vector<SurfacePoint> points = measured(patchOf(ball, 600, random), kNoise, 0.06, random);
  // Beside it a crumpled wall.
  for (const SurfacePoint& p : measured(patchOf(kWall, 600, 0.2, random), 0.004, 0.3, random)) {
    points.push_back({p.point + Vec3(1.0, 0, 0), p.normal});
  }
  const ProposalRules rules = rulesBeforeMeasuring(params);
  const Samples samples = samplesWith(rules.noise, points);
  List<Candidate> candidates;
  for (std::uint32_t k = 0; k < 7; ++k) {
    candidates.push_back(proposalAt(Plane{kWall.point + Vec3(1, 0, 0), kWall.normal}, samples, 600 + 50 * k));
  }
  for (std::uint32_t k = 0; k < 4; ++k) candidates.push_back(proposalAt(ball, samples, 50 * k));
  const NoiseModel noise = measureNoise(samples, candidates, rules).value();
  EXPECT_NEAR(noise.distance, kNoise, 0.2 * kNoise);
}

TEST(MeasuredNoise, OfExactPointsIsSmallButNotZero) {
  const Params params;
  Random random(84);
  const ProposalRules rules = rulesBeforeMeasuring(params);
  const Samples samples = samplesWith(rules.noise, patchOf(kBall, 300, random));
  const NoiseModel noise = measureNoise(samples, {proposalAt(kBall, samples, 0)}, rules).value();
  // Coordinates of 1 m in float are off by 1e-7.
  EXPECT_GT(noise.distance, 1e-5);
  EXPECT_LT(noise.distance, 0.1 * rules.noise.distance);
  EXPECT_GT(noise.angle, 1.0 * kDegree);
}

TEST(MeasuredNoise, IsNoneWhenThereIsNothingToMeasure) {
  const Params params;
  const ProposalRules rules = rulesBeforeMeasuring(params);
  EXPECT_FALSE(measureNoise(Samples(), {}, rules));
  Random random(85);
  const Samples few = samplesWith(rules.noise, patchOf(kBall, 15, random));
  EXPECT_FALSE(measureNoise(few, {proposalAt(kBall, few, 0)}, rules));
}

}  // namespace
}  // namespace primitect::noise_measurement_test
