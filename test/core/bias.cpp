// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The systematic error of fits to noisy points, before and after it is taken out.
#include "core/bias.h"

#include <gtest/gtest.h>

#include "test/support/fit_errors.h"

namespace primitect::bias_test {
namespace {

using test::NoisyFit;
using test::Patch;

constexpr int kPoints = 20000;  // average the noise down to where the bias shows

struct Errors {
  double before, after;
};

/// Mean normalised errors of fits to many points, whose random part alone gives 1.
Errors meanErrors(Kind kind, double noise, NoiseDirection direction) {
  constexpr int kSeeds = 20;
  Errors mean = {0.0, 0.0};
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Patch patch = test::randomPatch(kind, kPoints, random);
    const NoisyFit fit(patch, noise, direction, random);
    const Hessian covariance = measureCovariance(*fit.shape, fit.measured, fit.noise());
    const Shape corrected = fit.unbiased();
    mean.before += test::normalisedError(*fit.shape, patch.truth, covariance) / kSeeds;
    mean.after += test::normalisedError(corrected, patch.truth, covariance) / kSeeds;
  }
  return mean;
}

TEST(Bias, OfASphereIsTheSquareOfTheNoiseOverTheRadius) {
  constexpr double kNoise = 0.004, kRadius = 0.05;
  Random random(81);
  // Seen from all sides, so that the centre cannot follow.
  Patch patch = {Sphere{Vec3(0, 0, 1), kRadius}, {}};
  for (int i = 0; i < kPoints; ++i) {
    patch.points.push_back(test::pointOn(std::get<Sphere>(patch.truth), test::randomDirection(random)));
  }
  const NoisyFit fit(patch, kNoise, NoiseDirection::any, random);
  const Shape corrected = fit.unbiased();
  // Four standard deviations of the radius; Tukey's weights of 3 sigma cost a fifth of the points.
  const double tolerance = 4.0 * kNoise / std::sqrt(0.8 * kPoints);
  EXPECT_NEAR(std::get<Sphere>(*fit.shape).radius, kRadius + kNoise * kNoise / kRadius, tolerance);
  EXPECT_NEAR(std::get<Sphere>(corrected).radius, kRadius, tolerance);
}

TEST(Bias, IsTakenOutForNoiseOfAllAxes) {
  for (const Kind kind : {Kind::sphere, Kind::cylinder, Kind::cone}) {
    const Errors errors = meanErrors(kind, 0.004, NoiseDirection::any);
    EXPECT_GT(errors.before, 1.5) << kindName(kind);
    EXPECT_LT(errors.after, 1.5) << kindName(kind);
  }
}

TEST(Bias, OfAPlaneIsNoneWithNoiseOfAllAxes) {
  const Errors errors = meanErrors(Kind::plane, 0.004, NoiseDirection::any);
  EXPECT_NEAR(errors.after, errors.before, 0.05);
}

TEST(Bias, IsTakenOutForNoiseAlongTheRays) {
  for (const Kind kind : {Kind::plane, Kind::sphere, Kind::cylinder, Kind::cone}) {
    const Errors errors = meanErrors(kind, 0.004, NoiseDirection::along_ray);
    EXPECT_GT(errors.before, 2.0) << kindName(kind);
    EXPECT_LT(errors.after, 1.5) << kindName(kind);
  }
}

TEST(Bias, IsTakenOutWhenTheNoiseIsSmallerThanSaid) {
  Random random(82);
  const Patch patch = test::randomPatch(Kind::sphere, kPoints, random);
  const NoisyFit fit(patch, 0.002, NoiseDirection::any, random);
  const Sphere right = std::get<Sphere>(fit.unbiased());
  const Sphere too_large = std::get<Sphere>(fit.unbiased(2.0));
  const double taken_out = std::abs(std::get<Sphere>(*fit.shape).radius - right.radius);
  EXPECT_GT(taken_out, 1e-5);
  EXPECT_NEAR(too_large.radius, right.radius, 0.1 * taken_out);  // 5 %: squares beyond 3 sigma are cut off, and points
}

TEST(Bias, LeavesAShapeAloneThatNothingDetermines) {
  const Sphere sphere = {Vec3(0, 0, 1), 0.1};
  const auto millimetre = [](const Vec3&) { return 0.001; };
  for (const std::vector<Vec3>& points : {std::vector<Vec3>(), std::vector<Vec3>(5, Vec3(0, 0, 0.9))}) {
    const Sphere kept = std::get<Sphere>(withoutBias(sphere, points, millimetre, NoiseDirection::any));
    EXPECT_LT((kept.center - sphere.center).norm(), 1e-3);
    EXPECT_NEAR(kept.radius, sphere.radius, 1e-3);
  }
}

}  // namespace
}  // namespace primitect::bias_test
