// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The polynomials of the kernels against libm, over the whole range, with the errors that their comments state.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/portable_lanes.h"
//
#include "kernels/vector_math.h"

namespace primitect::kernels::approximations_test {
namespace {

constexpr int kSteps = 1000000;

TEST(SmallArcSine, IsWithinItsBoundUpToOneHalf) {
  double worst = 0.0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const float x = 0.5f * static_cast<float>(i) / kSteps;
    worst = std::max(worst, std::abs(smallArcSine(Floats{} + x)[0] - std::asin(static_cast<double>(x))));
  }
  EXPECT_LT(worst, 7e-7);
}

TEST(SmallSine, IsWithinItsBoundUpToOnePointThree) {
  double worst = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const float x = 1.3f * static_cast<float>(i) / kSteps;
    worst = std::max(worst, std::abs(smallSine(Floats{} + x)[0] - std::sin(static_cast<double>(x))));
  }
  EXPECT_LT(worst, 3e-7);
}

TEST(AngleInPlane, IsWithinItsBoundAllAround) {
  double worst = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = 2.0 * M_PI * (i + 0.5) / kSteps, length = std::pow(10.0, i % 9 - 4);
    const float x = static_cast<float>(length * std::cos(angle)), y = static_cast<float>(length * std::sin(angle));
    const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
    const double found = angleInPlane(Floats{} + y, Floats{} + x)[0];
    worst = std::max(worst, std::abs(found - (exact < 0.0 ? exact + 2.0 * M_PI : exact)));
  }
  EXPECT_LT(worst, 2.5e-6);
}

TEST(AngleInHalfPlane, IsThatOfThePlane) {
  for (const float x : {-2.0f, -1.0f, -0.5f, 0.0f, 0.5f, 1.0f, 2.0f}) {
    for (const float y : {0.0f, 0.5f, 1.0f, 2.0f}) {
      EXPECT_NEAR(angleInHalfPlane(Floats{} + y, Floats{} + x)[0], std::atan2(y, x), 2.5e-6) << x << " " << y;
    }
  }
}

TEST(AngleInQuadrant, IsZeroWhereThereIsNoDirection) { EXPECT_EQ(angleInQuadrant(Floats{}, Floats{})[0], 0.0f); }

}  // namespace
}  // namespace primitect::kernels::approximations_test
