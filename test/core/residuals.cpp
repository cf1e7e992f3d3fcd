// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gradients by local parameters against differences, in random poses.
#include "core/residuals.h"

#include <gtest/gtest.h>

#include "test/support/exact_shapes.h"

namespace primitect {
namespace {

using test::randomDirection;

std::vector<Shape> randomShapes(Random& random) {
  return {Plane{test::randomPoint(random), randomDirection(random)},
          Sphere{test::randomPoint(random), random.uniform(0.05, 0.5)},
          Cylinder{test::randomPoint(random), randomDirection(random), random.uniform(0.05, 0.5)},
          Cone{test::randomPoint(random), randomDirection(random), random.uniform(0.2, 1.2)}};
}

Shape steppedShape(const Shape& shape, const Gradient& step) {
  return std::visit([&](const auto& s) -> Shape { return stepped(s, step); }, shape);
}

/// The part of the surface behind a cone's apex has no gradient.
bool regular(const Shape& shape, const Vec3& p) {
  const Cone* cone = std::get_if<Cone>(&shape);
  return !cone || (p - cone->apex).dot(cone->axis) > 0.1;
}

TEST(Residuals, HaveTheGradientOfTheDistance) {
  constexpr double kStep = 1e-6;
  Random random(71);
  for (int round = 0; round < 100; ++round) {
    for (const Shape& shape : randomShapes(random)) {
      const Vec3 p = test::randomPoint(random);
      if (!regular(shape, p)) continue;
      const Residual r = residual(shape, p);
      EXPECT_NEAR(r.distance, distance(shape, p), 1e-12);
      for (int k = 0; k < kMostParameters; ++k) {
        const Gradient step = kStep * Gradient::Unit(k);
        const double difference = distance(steppedShape(shape, step), p) - distance(steppedShape(shape, -step), p);
        // A distance of at most 4 m curves by at most a few per metre: the error of a difference is of order kStep^2,
        // that of rounding 1e-16 / kStep.
        const double expected = k < parameterCount(kindOf(shape)) ? difference / (2.0 * kStep) : 0.0;
        EXPECT_NEAR(r.gradient[k], expected, 1e-7) << kindName(kindOf(shape)) << " " << k;
      }
    }
  }
}

/// A slender cone and a point beside it, far from its apex.
const Cone kSlender = {Vec3(0.1, 0.2, 0.3), Vec3(0, 0, 1), 0.1};
const Vec3 kBeside = kSlender.apex + Vec3(0.05, 0, 2.0);

TEST(SteppedBeside, MovesTheSurfaceAsTheGradientSays) {
  constexpr double kStep = 1e-6;
  const Vec3 p = kBeside + Vec3(0.1, 0.17, 0.05);
  const Residual r = residual(kSlender, p);
  for (int k = 0; k < kMostParameters; ++k) {
    const Gradient step = kStep * Gradient::Unit(k);
    const double ahead = distance(stepped(kSlender, step, kBeside), p);
    const double back = distance(stepped(kSlender, Gradient(-step), kBeside), p);
    EXPECT_NEAR(r.gradient[k], (ahead - back) / (2.0 * kStep), 1e-6) << k;
  }
}

TEST(SteppedBeside, KeepsTheCircleThatALargeStepKeeps) {
  // Half the angle, with the apex twice as far away: by the gradient nothing moves at a height of 2 m.
  const double height = 2.0, radius = height * std::tan(kSlender.half_angle);
  Gradient step = Gradient::Zero();
  step[5] = -0.05;
  step[2] = height * step[5] / (std::sin(kSlender.half_angle) * std::cos(kSlender.half_angle));
  const Cone cone = stepped(kSlender, step, kBeside);
  EXPECT_NEAR(cone.half_angle, 0.05, 1e-12);
  EXPECT_NEAR((kSlender.apex + height * kSlender.axis - cone.apex).dot(cone.axis) * std::tan(cone.half_angle), radius,
              1e-9);
}

TEST(SteppedBeside, OpensTheOtherWayPastACylinder) {
  const double height = 2.0;
  Gradient step = Gradient::Zero();
  step[5] = -0.15;
  step[2] = height * step[5] / (std::sin(kSlender.half_angle) * std::cos(kSlender.half_angle));
  const Cone cone = stepped(kSlender, step, kBeside);
  EXPECT_NEAR(cone.half_angle, 0.05, 1e-12);
  EXPECT_NEAR(cone.axis.z(), -1.0, 1e-12);
  EXPECT_GT((kBeside - cone.apex).dot(cone.axis), 0.0);
}

TEST(SteppedBeside, IsNoConeWhereTheCircleShrinksToNothing) {
  Gradient step = Gradient::Zero();
  step[2] = 3.0;  // the apex past the point
  EXPECT_LT(stepped(kSlender, step, kBeside).half_angle, 0.0);
}

}  // namespace
}  // namespace primitect
