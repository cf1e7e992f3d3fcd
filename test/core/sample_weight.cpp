// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Samples of the closer look speak for more where each has more pixels, and only they.
#include "core/sample_weight.h"

#include <gtest/gtest.h>

#include "core/verification.h"
#include "test/support/candidates.h"
#include "test/support/noisy_points.h"

namespace primitect::sample_weight_test {
namespace {

TEST(SampleWeight, IsOneUpToADozenPixelsThenInProportionUpToTwo) {
  EXPECT_EQ(sampleWeight(3000.0, 300), 1.0);
  EXPECT_EQ(sampleWeight(3600.0, 300), 1.0);
  EXPECT_DOUBLE_EQ(sampleWeight(5400.0, 300), 1.5);
  EXPECT_EQ(sampleWeight(9000.0, 300), 2.0);
  EXPECT_EQ(sampleWeight(9000.0, 0), 1.0);
}

/// What speaks for the ball of a frame of two draws, of which it has 200 and 100 samples.
float inliersOfBall(Verification& verification, double weight_of_later) {
  Random random(5);
  const Sphere ball = {Vec3(0, 0, 1), 0.08};
  const auto draw = [&](int count) { return test::measured(test::patchOf(ball, count, random), 0.001, 0.03, random); };
  const std::vector<test::SurfacePoint> first = draw(200), later = draw(100);
  verification.begin({1.0, false});
  List<Candidate> candidates = {test::candidate(ball, first[0], 50.0)};
  verification.measureNoise(test::samplesOf(first), candidates);
  verification.addSamples(test::samplesOf(first));
  verification.propose(candidates);
  verification.select();
  if (weight_of_later != 1.0) verification.weighLaterDraws(weight_of_later);
  verification.addSamples(test::samplesOf(later));
  verification.conclude();
  return verification.segments().size() == 1 ? verification.segments()[0].evidence.inliers : 0.0f;
}

TEST(SampleWeight, IsOfLaterDrawsUntilTheNextFrame) {
  Verification verification{Params()};
  const float of_one = inliersOfBall(verification, 1.0);
  ASSERT_GT(of_one, 280.0f);
  EXPECT_NEAR(inliersOfBall(verification, 2.0), of_one + 100.0f, 10.0f);
  EXPECT_EQ(inliersOfBall(verification, 1.0), of_one);
}

}  // namespace
}  // namespace primitect::sample_weight_test
