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
    const Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), -1);
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

TEST(TrustInFit, IsFullOfOtherKinds) {
  const Sphere ball = {Vec3(0, 0, 1), 0.06};
  const Cylinder tube = {Vec3(0, 0, 1), Vec3::UnitY(), 0.06};
  EXPECT_EQ(trustIn(tube, ballWithStep(ball, 0.01)), 1.0);
}

}  // namespace
}  // namespace primitect
