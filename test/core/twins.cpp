// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which balls pass for one thing.
#include "core/twins.h"

#include <gtest/gtest.h>

namespace primitect::twins_test {
namespace {

Hypothesis ball(double x, double radius, bool concave = false) {
  Hypothesis hypothesis;
  hypothesis.shape = Sphere{Vec3(x, 0, 1), radius};
  hypothesis.concave = concave;
  return hypothesis;
}

TEST(Twins, AreBallsThatNearlyCoincide) {
  EXPECT_TRUE(areTwins(ball(0.0, 0.081), ball(0.014, 0.074)));
  EXPECT_TRUE(areTwins(ball(0.014, 0.074), ball(0.0, 0.081)));
}

TEST(Twins, AreNotBallsThatPartlyHideEachOther) {
  EXPECT_FALSE(areTwins(ball(0.0, 0.08), ball(0.03, 0.08)));
  EXPECT_FALSE(areTwins(ball(0.0, 0.08), ball(0.0, 0.06)));
}

TEST(Twins, AreNotTheSidesOfAShell) {
  EXPECT_FALSE(areTwins(ball(0.0, 0.08), ball(0.0, 0.077, true)));
  EXPECT_TRUE(areTwins(ball(0.0, 0.08, true), ball(0.0, 0.077, true)));
}

TEST(Twins, AreNoOtherKinds) {
  Hypothesis can = ball(0.0, 0.08);
  can.shape = Cylinder{Vec3(0, 0, 1), Vec3::UnitY(), 0.08};
  EXPECT_FALSE(areTwins(can, can));
}

}  // namespace
}  // namespace primitect::twins_test
