// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Slices of a spheroid, a barrel's side, against what is fitted to them.
#include "core/bulge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/extent.h"
#include "core/random.h"
#include "primitect/detector.h"

namespace primitect::bulge_test {
namespace {

constexpr double kRadius = 0.1, kHalf = 0.05, kNoise = 0.001;

/// The side that is seen of what has a circle of this radius around the x axis in the middle, and curves along the axis
/// so much of how it curves around it, as a parabola.
SeenPoints sideOf(double bulge, double noise, double slope = 0.0, int count = 1000, std::uint64_t seed = 3) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int k = 0; k < count; ++k) {
    const double height = random.uniform(-kHalf, kHalf), turn = random.uniform(-1.2, 1.2);
    const double radius =
        kRadius + slope * height - 0.5 * bulge / kRadius * height * height + noise * random.gaussian();
    points.push_back(Vec3(height, radius * std::sin(turn), 1.0 - radius * std::cos(turn)));
  }
  return points;
}

const Shape kTube = Cylinder{Vec3(0, 0, 1), Vec3::UnitX(), kRadius};

Bulge bulgeOn(const Shape& shape, const SeenPoints& points, double noise) {
  return bulgeOf(shape, points, measureExtent(shape, points, {}), [noise](const Vec3&) { return noise; });
}

void expectExactly(const Bulge& bulge, double expected) {
  EXPECT_NEAR(bulge.least, expected, 0.001 + 0.04 * std::abs(expected));
  EXPECT_NEAR(bulge.most, expected, 0.001 + 0.04 * std::abs(expected));
}

TEST(Bulge, IsTheCurvatureAlongTheAxisOverThatAroundIt) {
  for (const double bulge : {-0.5, 0.0, 0.1, 0.25, 1.0}) expectExactly(bulgeOn(kTube, sideOf(bulge, 0.0), 0.0), bulge);
}

TEST(Bulge, OfAConeIsMeasuredAlongItsSide) {
  constexpr double kAngle = 0.3;
  const double slope = std::tan(kAngle);
  const Cone cone = {Vec3(-kRadius / slope, 0, 1), Vec3::UnitX(), kAngle};
  expectExactly(bulgeOn(cone, sideOf(0.0, 0.0, slope), 0.0), 0.0);
  // Along the side it is 1 / cos longer than along the axis, and a distance from it cos of one from the axis; circles
  // around it are curved by cos / radius.
  const double along = std::pow(std::cos(kAngle), 3), around = std::cos(kAngle);
  expectExactly(bulgeOn(cone, sideOf(0.25, 0.0, slope), 0.0), 0.25 * along / around);
}

TEST(Bulge, MayBeHalfOfTheNoiseLessOrMore) {
  // A bend of one standard deviation between the ends is a curvature of 3 / kHalf^2 of it.
  constexpr double kByNoise = 0.5 * kNoise * 3.0 / (kHalf * kHalf) * kRadius;
  double least = 0.0, most = 0.0;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    const Bulge bulge = bulgeOn(kTube, sideOf(0.5, kNoise, 0.0, 1000, seed), kNoise);
    least += bulge.least / 8.0, most += bulge.most / 8.0;
  }
  EXPECT_NEAR(least, 0.5 - kByNoise, 0.03);
  EXPECT_NEAR(most, 0.5 + kByNoise, 0.03);
  // Of exact points it is that of half of the noise.
  EXPECT_NEAR(bulgeOn(kTube, sideOf(0.5, 0.0), kNoise).least, 0.5 - 0.5 * kByNoise, 0.02);
}

TEST(Bulge, MayBeAnythingOfOtherKindsAndAFewPoints) {
  const auto is_open = [](const Bulge& bulge) { return bulge.least == 0.0 && bulge.most == 1.0; };
  EXPECT_TRUE(is_open(bulgeOf(kTube, {}, {}, [](const Vec3&) { return 0.0; })));
  EXPECT_TRUE(is_open(bulgeOn(kTube, sideOf(1.0, 0.0, 0.0, 7), 0.0)));
  EXPECT_TRUE(is_open(bulgeOn(kTube, std::vector<Vec3>(20, Vec3(0, 0, 0.9)), 0.0)));  // one place
  EXPECT_TRUE(is_open(bulgeOn(Sphere{Vec3(0, 0, 1), kRadius}, sideOf(0.5, 0.0), 0.0)));
}

TEST(TrustInStraightSide, IsFullOfCylindersAndNoneOfBarrels) {
  EXPECT_EQ(trustInStraightSide(bulgeOn(kTube, sideOf(0.0, kNoise), kNoise)), 1.0);
  EXPECT_EQ(trustInStraightSide({0.04, 0.2}), 1.0);
  EXPECT_NEAR(trustInStraightSide({0.07, 0.2}), 0.5, 1e-9);
  EXPECT_EQ(trustInStraightSide({0.1, 0.2}), 0.0);
  EXPECT_EQ(trustInStraightSide({}), 1.0);
}

TEST(SliceOfBall, IsWhatBulgesAsABallMay) {
  EXPECT_TRUE(mayBeSliceOfBall(bulgeOn(kTube, sideOf(1.0, kNoise), kNoise)));
  EXPECT_FALSE(mayBeSliceOfBall(bulgeOn(kTube, sideOf(0.5, kNoise), kNoise)));  // a barrel
  EXPECT_FALSE(mayBeSliceOfBall(bulgeOn(kTube, sideOf(0.0, kNoise), kNoise)));
  EXPECT_FALSE(mayBeSliceOfBall({}));
}

/// A spheroid about the y axis, cut off above and below, before a wall.
Cloud imageOf(double half_axis) {
  constexpr std::uint32_t kWidth = 320, kHeight = 240;
  constexpr double kFocal = 260.0, kMiddle = 1.0, kWall = 1.5;
  Random random(1);
  Cloud cloud;
  cloud.reset(kWidth, kHeight, false);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const Vec3 ray = Vec3((i % kWidth - 159.5) / kFocal, (i / kWidth - 119.5) / kFocal, 1.0);
    const Vec3 scale(1.0 / kRadius, 1.0 / half_axis, 1.0 / kRadius);
    const Vec3 way = ray.cwiseProduct(scale), from = Vec3(0, 0, kMiddle).cwiseProduct(scale);
    const double a = way.squaredNorm(), b = way.dot(from), root = b * b - a * (from.squaredNorm() - 1.0);
    double z = root > 0.0 ? (b - std::sqrt(root)) / a : kWall;
    if (std::abs(z * ray.y()) > kRadius) z = kWall;
    z += kNoise * random.gaussian();
    const Vec3 point = z * ray;
    cloud.setPoint(i, static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z()),
                   {0.1f, 2.0f});
  }
  return cloud;
}

int curved(const Cloud& cloud, const Params& params) {
  Detector detector{params};
  int count = 0;
  for (const Detection& item : detector.detect(cloud).items) count += kindOf(item.shape) == Kind::plane ? 0 : 1;
  return count;
}

TEST(DetectorOfBarrels, FindsNoCylinderAndNoConeThere) {
  Params without;
  without.left_out.add(Step::trust_in_evenness);
  EXPECT_EQ(curved(imageOf(100.0 * kRadius), {}), 1);
  EXPECT_GE(curved(imageOf(2.0 * kRadius), without), 1);
  EXPECT_EQ(curved(imageOf(2.0 * kRadius), {}), 0);
}

}  // namespace
}  // namespace primitect::bulge_test
