// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Bands of balls, and patches that are none. Thin tubes and planes seen edge-on: competition.cpp.
#include "core/indistinct.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/ball_band.h"

namespace primitect::indistinct_test {
namespace {

const Sphere kBall = {Vec3(0.1, -0.2, 1.0), 0.08};
constexpr double kSigma = 0.002;  // m

/// A patch on the side that faces the sensor with these spreads (m, one standard deviation).
Moments patch(double narrow, double wide) {
  Moments moments;
  moments.count = 100;
  moments.mean_point = kBall.center - kBall.radius * Vec3::UnitZ();
  moments.points.diagonal() = Vec3(narrow * narrow, wide * wide, 1e-6);
  return moments;
}

bool isRing(const Shape& shape, const Moments& moments, const NoiseModel& noise) {
  return mayBeRing(shape, {moments, kSigma, noise, false});
}

TEST(Indistinct, BandHasTheShareOfItsSpreadsAndRisesAcross) {
  const Moments moments = patch(0.005, 0.03);
  const BallBand band = bandOn(kBall, moments.mean_point, moments.points);
  EXPECT_NEAR(band.elongation, 6.0, 1e-9);
  const double width = std::sqrt(12.0) * 0.005;
  EXPECT_NEAR(band.rise, width * width / (8.0 * kBall.radius), 1e-9);
}

TEST(Indistinct, NarrowBandOfABallMayBeARing) {
  const NoiseModel camera = {0.0, 0.002}, list = {kSigma, 0.0};
  EXPECT_TRUE(isRing(kBall, patch(0.005, 0.03), camera));
  EXPECT_FALSE(isRing(kBall, patch(0.005, 0.019), camera)) << "not long enough to be a ring";
  EXPECT_FALSE(isRing(kBall, patch(0.0125, 0.06), camera)) << "rises by 1.5 deviations of the noise";
  EXPECT_FALSE(isRing(kBall, patch(0.005, 0.03), list));
  EXPECT_FALSE(isRing(Cylinder{kBall.center, Vec3::UnitX(), 0.08}, patch(0.005, 0.03), camera));
}

}  // namespace
}  // namespace primitect::indistinct_test
