// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Trust in a ball by how its points stray.
#include "core/misfit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect {
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

/// Noisy points of the side that is seen: the half of them that is nearest to the sensor lies so much farther out than
/// the other that the variance between the two is so many times that of the noise.
SeenPoints unevenBall(const Sphere& ball, double unevenness, std::size_t count) {
  constexpr double kHalf = 2.0 / M_PI;  // of a square: in the circle with this squared radius, times that of its sides
  Random random(6);
  const double step = std::sqrt(unevenness) * kSigma;
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 way{random.uniform(-1, 1), random.uniform(-1, 1), -1};
    const double out = way.head<2>().squaredNorm() < kHalf ? step : -step;
    const double radius = ball.radius + out + kSigma * random.gaussian();
    points.push_back(ball.center + radius * way.normalized());
  }
  return points;
}

TEST(Unevenness, IsTheVarianceBetweenPartsOfABallOverThatWithin) {
  const Sphere ball = {Vec3(0, 0, 1), 0.06};
  for (const double variance : {0.0, 0.5, 1.0, 2.0}) {
    EXPECT_NEAR(unevennessOf(ball, unevenBall(ball, variance, 5000)), variance, 0.02 + 0.3 * variance);
  }
}

TEST(Unevenness, IsNotToldByAFewPoints) {
  const Sphere ball = {Vec3(0, 0, 1), 0.06};
  EXPECT_EQ(unevennessOf(ball, {}), 0.0);
  EXPECT_EQ(unevennessOf(ball, unevenBall(ball, 2.0, 40)), 0.0);
  EXPECT_EQ(unevennessOf(ball, std::vector<Vec3>(300, Vec3(0, 0, 0.94))), 0.0);  // one place
  EXPECT_EQ(unevennessOf(ball, std::vector<Vec3>(300, ball.center)), 0.0);
}

TEST(TrustInEvenness, IsFullOfBallsWhateverTheNoiseAndNoneOfWhatIsClearlyUneven) {
  const Sphere ball = {Vec3(0, 0, 1), 0.06};
  EXPECT_EQ(trustInEvenness(ball, unevenBall(ball, 0.0, 1000)), 1.0);
  EXPECT_EQ(trustInEvenness(ball, unevenBall(ball, 1.0, 1000)), 0.0);
  const Cylinder tube = {Vec3(0, 0, 1), Vec3::UnitY(), 0.06};
  EXPECT_EQ(trustInEvenness(tube, unevenBall(ball, 1.0, 1000)), 1.0);
}

TEST(TrustInFit, IsFullOfOtherKinds) {
  const Sphere ball = {Vec3(0, 0, 1), 0.06};
  const Cylinder tube = {Vec3(0, 0, 1), Vec3::UnitY(), 0.06};
  EXPECT_EQ(trustIn(tube, ballWithStep(ball, 0.01)), 1.0);
}

}  // namespace
}  // namespace primitect
