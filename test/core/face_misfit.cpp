// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A face strays as noise lets it, whatever a few points do that are not of it; the side of a round thing does not.
#include "core/face_misfit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/random.h"

namespace primitect::face_misfit_test {
namespace {

constexpr double kSigma = 0.002;  // m, along z

double noise(const Vec3&) { return kSigma; }

/// Of the plane z = 1 m, seen at a slant: 1000 points whose depth is off by noise and by what `bend` (m) says of a
/// place from -1 to 1 across it, of which the last `others` are 2.5 standard deviations lower.
template <class Bend>
double unevennessOf(const Bend& bend, int others = 0) {
  constexpr int kPoints = 1000;
  Random random(3);
  Cloud cloud;
  cloud.reset(kPoints, 1, false);
  for (int i = 0; i < kPoints; ++i) {
    const double across = 2.0 * random.uniform() - 1.0;
    const double off = kSigma * random.gaussian() + bend(across) + (i >= kPoints - others ? 2.5 * kSigma : 0.0);
    cloud.setPoint(static_cast<std::size_t>(i), static_cast<float>(0.3 + 0.04 * across), 0.0f,
                   static_cast<float>(1.0 + off), {});
  }
  List<std::uint32_t> all(kPoints);
  std::iota(all.begin(), all.end(), 0u);
  return unevenness(cloud, all, {Vec3(0.0, 0.0, 1.0), -Vec3::UnitZ()}, noise);
}

double flat(double) { return 0.0; }

TEST(Unevenness, OfAFaceIsThatOfNoise) { EXPECT_NEAR(unevennessOf(flat), 1.0, 0.15); }

TEST(Unevenness, OfAFaceWithATenthOfOtherPointsIsHardlyMore) {
  EXPECT_LT(unevennessOf(flat, 100), kAsEven);
  EXPECT_GT(unevennessOf(flat, 500), kAsEven);
}

TEST(Unevenness, OfAPlaneAcrossARoundSideIsMore) {
  // From 3 standard deviations above to 3 below.
  EXPECT_GT(unevennessOf([](double across) { return 3.0 * kSigma * (1.0 - 2.0 * across * across); }), kAsEven);
}

TEST(Unevenness, IsThatOfNoiseAlongRaysHoweverThePlaneIsTurned) {
  // A plane through a point straight ahead, at 60 deg: noise along z is half as large across it.
  Random random(4);
  Cloud cloud;
  cloud.reset(1000, 1, false);
  const Vec3 normal(std::sin(M_PI / 3.0), 0.0, -std::cos(M_PI / 3.0));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double x = 0.02 * random.uniform(), z = 1.0 + x * std::tan(M_PI / 3.0);
    const double measured = z + kSigma * random.gaussian();
    cloud.setPoint(i, static_cast<float>(x * measured / z), 0.0f, static_cast<float>(measured), {});
  }
  List<std::uint32_t> all(cloud.size());
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_NEAR(unevenness(cloud, all, {Vec3(0.0, 0.0, 1.0), normal}, noise), 1.0, 0.15);
  EXPECT_EQ(unevenness(cloud, {}, {Vec3(0.0, 0.0, 1.0), normal}, noise), 0.0);
}

TEST(Unevenness, IsANumberAlsoOfAPlaneThroughTheSensor) {
  Cloud cloud;
  cloud.reset(8, 1, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.setPoint(i, 0.1f * static_cast<float>(i), 0.001f * static_cast<float>(i % 2), 1.0f, {});
  }
  List<std::uint32_t> all(cloud.size());
  std::iota(all.begin(), all.end(), 0u);
  const double uneven = unevenness(cloud, all, {Vec3::Zero(), Vec3::UnitY()}, noise);
  EXPECT_TRUE(std::isfinite(uneven));
  EXPECT_GT(uneven, kAsEven);
}

}  // namespace
}  // namespace primitect::face_misfit_test
