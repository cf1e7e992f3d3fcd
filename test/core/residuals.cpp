// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gradients by local parameters against differences, in random poses.
#include "core/residuals.h"

#include <gtest/gtest.h>

#include "test/support/exact_shapes.h"

namespace primitect::residuals_test {
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

Gradient stepOf(int parameter, double size) { return size * Gradient::Unit(parameter); }

TEST(CircleBeside, IsWhereTheConeIsBesideThePoint) {
  const Circle circle = circleBeside(kBeside, kSlender);
  EXPECT_NEAR((circle.middle - (kSlender.apex + 2.0 * kSlender.axis)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(circle.radius, 2.0 * std::tan(0.1), 1e-12);
  EXPECT_LT(circleBeside(kSlender.apex - 0.1 * kSlender.axis, kSlender).radius, 0.0);
}

TEST(SteppedBeside, IsTheConeItselfWithoutAStep) {
  const Cone cone = steppedBeside(kBeside, kSlender, Gradient::Zero());
  EXPECT_NEAR((cone.apex - kSlender.apex).norm(), 0.0, 1e-12);
  EXPECT_EQ(cone.half_angle, kSlender.half_angle);
}

TEST(SteppedBeside, KeepsTheCircleWhenTheConeOpensMore) {
  const Cone cone = steppedBeside(kBeside, kSlender, stepOf(5, 0.05));
  EXPECT_NEAR(cone.half_angle, 0.15, 1e-12);
  const Circle before = circleBeside(kBeside, kSlender), after = circleBeside(kBeside, cone);
  EXPECT_NEAR((before.middle - after.middle).norm(), 0.0, 1e-9);
  EXPECT_NEAR(before.radius, after.radius, 1e-9);
}

TEST(SteppedBeside, MovesTheCircleAndTurnsAboutItsMiddle) {
  const Turn turn(kSlender.axis);
  const Circle before = circleBeside(kBeside, kSlender);
  const Circle moved = circleBeside(kBeside, steppedBeside(kBeside, kSlender, stepOf(1, 0.01)));
  EXPECT_NEAR((moved.middle - before.middle - 0.01 * turn.second).norm(), 0.0, 1e-12);
  EXPECT_NEAR(circleBeside(kBeside, steppedBeside(kBeside, kSlender, stepOf(4, 0.02))).radius, before.radius + 0.02,
              1e-12);
  const Cone turned = steppedBeside(kBeside, kSlender, stepOf(2, 0.1));
  EXPECT_NEAR(distance(Cylinder{turned.apex, turned.axis, 1.0}, before.middle), -1.0, 1e-9);
  EXPECT_NEAR(turned.axis.dot(turn.first), 0.1, 0.001);
}

TEST(SteppedBeside, OpensTheOtherWayPastACylinder) {
  const Cone cone = steppedBeside(kBeside, kSlender, stepOf(5, -0.15));
  EXPECT_NEAR(cone.half_angle, 0.05, 1e-12);
  EXPECT_NEAR(cone.axis.z(), -1.0, 1e-12);
  EXPECT_GT((kBeside - cone.apex).dot(cone.axis), 0.0);
}

TEST(SteppedBeside, IsNoConeWhereTheCircleShrinksToNothing) {
  EXPECT_LT(steppedBeside(kBeside, kSlender, stepOf(4, -0.3)).half_angle, 0.0);
}

}  // namespace
}  // namespace primitect::residuals_test
