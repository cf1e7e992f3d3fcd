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

}  // namespace
}  // namespace primitect
