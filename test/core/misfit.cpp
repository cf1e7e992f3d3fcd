// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Trust in a ball by how its points stray.
#include "core/misfit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect::misfit_test {
namespace {

constexpr double kSigma = 0.002;
double sigma(const Vec3&) { return kSigma; }

/// Points of the side of a ball that is seen, those of its lower half so much (m) too far out, the others too far in.
SeenPoints ballWithStep(const Sphere& ball, double step) {
  Random random(5);
  std::vector<Vec3> points;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 way{random.uniform(-1, 1), random.uniform(-1, 1), -1};
    points.push_back(ball.center + (ball.radius + std::copysign(step, way.y())) * way.normalized());
  }
  return points;
}

double trustIn(const Shape& shape, const SeenPoints& points) {
  return trustInFit(shape, rmsDistance(shape, points), points, sigma);
}

TEST(TrustInFit, IsFullWithinTheNoiseAndNoneOfWhatStraysClearly) {
  const Sphere ball = {Vec3(0, 0, 1), 0.06};
  EXPECT_EQ(trustIn(ball, ballWithStep(ball, 1.2 * kSigma)), 1.0);
  EXPECT_NEAR(trustIn(ball, ballWithStep(ball, 1.35 * kSigma)), 0.5, 0.01);
  EXPECT_EQ(trustIn(ball, ballWithStep(ball, 1.5 * kSigma)), 0.0);
}

/// Noisy points of the side that is seen, every other one of its middle, which lies so much farther out than the rim
/// that the variance between the two is so many times that of the noise. Nothing is where the rings' bound will be.
SeenPoints unevenBall(const Sphere& ball, double unevenness, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const double step = std::sqrt(unevenness) * kSigma;
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < count; ++k) {
    const bool middle = k % 2 == 0;
    const double aside = std::sqrt(middle ? random.uniform(0.0, 0.5) : random.uniform(0.6, 1.0));
    const double turn = random.uniform(0.0, 2.0 * M_PI);
    const Vec3 way(aside * std::cos(turn), aside * std::sin(turn), -1.0);
    const double radius = ball.radius + (middle ? step : -step) + kSigma * random.gaussian();
    points.push_back(ball.center + radius * way.normalized());
  }
  return points;
}

const Sphere kBall = {Vec3(0, 0, 1), 0.06};

TEST(Unevenness, IsTheVarianceBetweenPartsOfABallOverThatWithin) {
  constexpr int kDraws = 20;
  for (const double variance : {0.0, 0.5, 1.0, 2.0}) {
    double mean = 0.0;
    for (int draw = 1; draw <= kDraws; ++draw) {
      mean += unevennessOf(kBall, unevenBall(kBall, variance, 512, draw), 0.0) / kDraws;
    }
    // Of 512 points it scatters by .2 at 2, so that the mean of twenty is known to .045; below 0 it is 0.
    EXPECT_NEAR(mean, variance, 0.02 + 0.07 * variance) << variance;
  }
}

TEST(Unevenness, IsNotToldByAFewPoints) {
  EXPECT_EQ(unevennessOf(kBall, {}, 0.0), 0.0);
  EXPECT_EQ(unevennessOf(kBall, unevenBall(kBall, 2.0, 40, 1), 0.0), 0.0);
  EXPECT_EQ(unevennessOf(kBall, std::vector<Vec3>(300, Vec3(0, 0, 0.94)), 0.0), 0.0);  // one place
  EXPECT_EQ(unevennessOf(kBall, std::vector<Vec3>(300, kBall.center), 0.0), 0.0);
}

TEST(TrustInEvenness, IsFullOfBallsWhateverTheNoiseAndNoneOfWhatIsClearlyUneven) {
  for (const bool of_depth_camera : {false, true}) {
    EXPECT_EQ(trustInEvenness(kBall, unevenBall(kBall, 0.0, 1000, 1), sigma, of_depth_camera), 1.0);
    EXPECT_EQ(trustInEvenness(kBall, unevenBall(kBall, 3.0, 1000, 1), sigma, of_depth_camera), 0.0);
    const Cylinder tube = {kBall.center, Vec3::UnitY(), kBall.radius};
    EXPECT_EQ(trustInEvenness(tube, unevenBall(kBall, 3.0, 1000, 1), sigma, of_depth_camera), 1.0);
  }
}

TEST(TrustInEvenness, IsFullWhereFitsEndOnExactPoints) {
  const SeenPoints exact = ballWithStep(kBall, 0.05 * kSigma);
  EXPECT_GT(unevennessOf(kBall, exact, 0.0), 0.6);
  EXPECT_EQ(trustInEvenness(kBall, exact, sigma, false), 1.0);
}

TEST(TrustInEvenness, KnowsThatDepthCamerasBendWhatTheySee) {
  const SeenPoints bent = unevenBall(kBall, 0.5, 4000, 1);
  EXPECT_LT(trustInEvenness(kBall, bent, sigma, false), 0.9);
  EXPECT_EQ(trustInEvenness(kBall, bent, sigma, true), 1.0);
}

TEST(TrustInFit, IsFullOfOtherKinds) {
  const Sphere ball = {Vec3(0, 0, 1), 0.06};
  const Cylinder tube = {Vec3(0, 0, 1), Vec3::UnitY(), 0.06};
  EXPECT_EQ(trustIn(tube, ballWithStep(ball, 0.01)), 1.0);
}

}  // namespace
}  // namespace primitect::misfit_test
