// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Linear interpolation weights: mass one, value kept, also at the borders and on the ball.
#include <gtest/gtest.h>

#include "core/axis_ball.h"
#include "test/support/exact_shapes.h"

namespace primitect::spreading_test {
namespace {

using kernels::BallSpread;
using kernels::LinearSpread;

TEST(LinearSpread, KeepsMassAndValueBetweenTheOuterCentres) {
  for (double value = 0.5; value <= 39.5; value += 0.37) {
    const LinearSpread s = kernels::spreadLinear(static_cast<float>(value), 40);
    EXPECT_NEAR(s.weight[0] + s.weight[1], 1.0, 1e-6);
    EXPECT_NEAR(s.weight[0] * (s.bin[0] + 0.5) + s.weight[1] * (s.bin[1] + 0.5), value, 1e-5);
    EXPECT_LE(s.bin[1] - s.bin[0], 1);
  }
}

TEST(LinearSpread, GivesAllToTheOuterBinBeyondItsCentre) {
  for (const float value : {0.0f, 0.2f, 39.7f, 40.0f}) {
    const LinearSpread s = kernels::spreadLinear(value, 40);
    const int outer = value < 1.0f ? 0 : 39;
    float in_outer = 0.0f;
    for (int k = 0; k < 2; ++k) {
      EXPECT_GE(s.bin[k], 0);
      EXPECT_LT(s.bin[k], 40);
      if (s.bin[k] == outer) in_outer += s.weight[k];
    }
    EXPECT_FLOAT_EQ(in_outer, 1.0f) << value;
  }
}

TEST(CircularSpread, WrapsAround) {
  const LinearSpread s = kernels::spreadCircular(17.75f, 18);
  EXPECT_EQ(s.bin[0], 17);
  EXPECT_EQ(s.bin[1], 0);
  EXPECT_FLOAT_EQ(s.weight[0], 0.25f);
  EXPECT_FLOAT_EQ(s.weight[1], 0.75f);
  const LinearSpread negative = kernels::spreadCircular(-0.25f, 18);
  EXPECT_EQ(negative.bin[0], 17);
  EXPECT_FLOAT_EQ(negative.weight[1], 0.75f);
}

class BallSpreadTest : public ::testing::Test {
 protected:
  BallSpread spread(const Vec3& axis) const {
    return spreadOnBall(ball_.view(),
                        {static_cast<float>(axis.x()), static_cast<float>(axis.y()), static_cast<float>(axis.z())});
  }

  /// Weighted mean of the bins' directions, signs aligned with the axis.
  Vec3 mean(const Vec3& axis, const BallSpread& s) const {
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
      const Vec3& direction = ball_.direction(s.bin[k]);
      sum += s.weight[k] * (direction.dot(axis) < 0.0 ? Vec3(-direction) : direction);
    }
    return sum.normalized();
  }

  AxisBall ball_{10.0 * M_PI / 180.0};
};

TEST_F(BallSpreadTest, KeepsMassForAnyAxis) {
  Random random(1);
  for (int trial = 0; trial < 5000; ++trial) {
    const double length = random.uniform(0.1, 3.0);
    const BallSpread s = spread(length * test::randomDirection(random));
    float mass = 0.0f;
    for (int k = 0; k < 4; ++k) {
      EXPECT_GE(s.weight[k], 0.0f);
      ASSERT_GE(s.bin[k], 0);
      ASSERT_LT(s.bin[k], ball_.binCount());
      mass += s.weight[k];
    }
    EXPECT_NEAR(mass, 1.0f, 1e-5f);
  }
}

TEST_F(BallSpreadTest, MeansTheAxisWithinAFractionOfABin) {
  Random random(2);
  double worst = 0.0;
  for (int trial = 0; trial < 5000; ++trial) {
    const Vec3 axis = test::randomDirection(random);
    worst = std::max(worst, test::lineAngle(mean(axis, spread(axis)), axis));
  }
  // Bins of unlike rings do not line up: the paper's "non-exact" weights. A sixth of the 10 deg bin.
  EXPECT_LT(worst, 10.0 / 6.0 * M_PI / 180.0);
}

TEST_F(BallSpreadTest, IsExactInTheFlatTrianglesAroundThePole) {
  for (double azimuth = 0.0; azimuth < 2.0 * M_PI; azimuth += 0.1) {
    const double polar = 3.0 * M_PI / 180.0;
    const Vec3 axis(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
    // Flat instead of curved over 10 deg: an error of the third order.
    EXPECT_LT(test::lineAngle(mean(axis, spread(axis)), axis), 0.03 * M_PI / 180.0);
  }
}

TEST_F(BallSpreadTest, GivesThePoleAllOfAPoleAxis) {
  const BallSpread s = spread(-Vec3::UnitZ());
  float at_pole = 0.0f;
  for (int k = 0; k < 4; ++k) at_pole += s.bin[k] == 0 ? s.weight[k] : 0.0f;
  EXPECT_FLOAT_EQ(at_pole, 1.0f);
}

TEST_F(BallSpreadTest, TreatsOppositeAxesAlike) {
  Random random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 axis = test::randomDirection(random);
    std::vector<double> votes(ball_.binCount(), 0.0);
    const BallSpread forth = spread(axis), back = spread(-axis);
    for (int k = 0; k < 4; ++k) {
      votes[forth.bin[k]] += forth.weight[k];
      votes[back.bin[k]] -= back.weight[k];
    }
    for (const double difference : votes) EXPECT_NEAR(difference, 0.0, 1e-4);
  }
}

TEST_F(BallSpreadTest, PutsAnAxisOnTheEquatorIntoTheEquatorsBins) {
  const BallSpread s = spread(Vec3(std::cos(0.3), std::sin(0.3), 0.0));
  for (int k = 0; k < 4; ++k) {
    if (s.weight[k] > 1e-5f) {
      EXPECT_NEAR(ball_.direction(s.bin[k]).z(), 0.0, 1e-9);
    }
  }
}

TEST(AxisBall, HasBinsOfNearlyEqualSizeAndEachAxisOnce) {
  const AxisBall ball(10.0 * M_PI / 180.0);
  // 2 pi / (10 deg)^2 = 206.3 square bins fit on the hemisphere.
  EXPECT_NEAR(ball.binCount(), 206, 5);
  for (int a = 0; a < ball.binCount(); ++a) {
    EXPECT_GE(ball.direction(a).z(), -1e-12);
    for (int b = 0; b < a; ++b) {
      EXPECT_GT(test::lineAngle(ball.direction(a), ball.direction(b)), 7.0 * M_PI / 180.0);
    }
  }
}

TEST(AxisBall, NeighborhoodsHoldWhatAVoteNearTheBinTouches) {
  const AxisBall ball(10.0 * M_PI / 180.0);
  for (int bin = 0; bin < ball.binCount(); ++bin) {
    const List<int>& near = ball.neighborhood(bin);
    EXPECT_EQ(near.front(), bin);
    EXPECT_GE(near.size(), 7u);
    EXPECT_LE(near.size(), 12u);
    for (const int other : near) {
      EXPECT_LT(test::lineAngle(ball.direction(bin), ball.direction(other)), 16.1 * M_PI / 180.0);
    }
  }
}

}  // namespace
}  // namespace primitect::spreading_test
