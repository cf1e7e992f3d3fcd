// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Patches whose points err alone or in groups of neighbours.
#include "core/shared_noise.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "test/support/fit_errors.h"

namespace primitect::shared_noise_test {
namespace {

using test::kKinds;
using test::Patch;

constexpr double kNoise = 0.002;
double noise(const Vec3&) { return kNoise; }

struct Fit {
  Shape shape;
  std::vector<Vec3> points;
};

/// Points of one cube of this edge (m) share their deviation along the normal; 0: none do.
Fit fitWithSharedNoise(const Patch& patch, double edge, Random& random) {
  std::map<std::tuple<int, int, int>, double> shared;
  std::vector<test::SurfacePoint> points = patch.points;
  for (test::SurfacePoint& p : points) {
    double deviation = random.gaussian();
    if (edge > 0.0) {
      const Eigen::Vector3i cube = (p.point / edge).array().floor().cast<int>();
      deviation = shared.emplace(std::make_tuple(cube.x(), cube.y(), cube.z()), deviation).first->second;
    }
    p.point += kNoise * deviation * p.normal;
  }
  Fit fit{*test::fitTo(points, patch.truth, noise), {}};
  for (const test::SurfacePoint& p : points) fit.points.push_back(p.point);
  return fit;
}

TEST(SharedNoise, OfIndependentPointsIsOneButForChance) {
  for (const Kind kind : kKinds) {
    for (const int count : {60, 300, 8192}) {
      int found = 0;
      double more = 0.0;
      for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        const Fit fit = fitWithSharedNoise(test::randomPatch(kind, count, random), 0.0, random);
        const SharedNoise shared = measureSharedNoise(fit.shape, fit.points, noise);
        found += shared.all > 1.0 ? 1 : 0;
        more += (shared.all - shared.shown) / 40.0;
      }
      // Two standard deviations of a skewed distribution: one in twenty, of 40 rarely more than 6.
      EXPECT_LE(found, 6) << kindName(kind) << " " << count;
      EXPECT_LT(more, 0.1) << kindName(kind) << " " << count;
    }
  }
}

TEST(SharedNoise, MakesTheCovarianceThatOfTheErrors) {
  constexpr int kSeeds = 40;
  for (const Kind kind : kKinds) {
    double alone = 0.0, shared = 0.0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      Random random(seed);
      const Patch patch = test::randomPatch(kind, 4000, random);
      const Fit fit = fitWithSharedNoise(patch, 0.01, random);
      const Hessian covariance = measureCovariance(fit.shape, fit.points, noise);
      const double error = test::normalisedError(fit.shape, patch.truth, covariance);
      alone += error / kSeeds;
      shared += error / measureSharedNoise(fit.shape, fit.points, noise).all / kSeeds;
    }
    // How much neighbours share differs over the surface, one number for all is a makeshift: a factor of two.
    EXPECT_GT(alone, 4.0) << kindName(kind);
    EXPECT_GT(shared, 0.5) << kindName(kind);
    EXPECT_LT(shared, 2.0) << kindName(kind);
  }
}

/// A plane of side by side points, each off by what g by g neighbouring numbers are in the mean.
Fit planeInGrains(int g, int side, Random& random) {
  constexpr double kSpacing = 0.003;
  const int wide = side + g - 1;
  std::vector<double> numbers;
  for (int k = 0; k < wide * wide; ++k) numbers.push_back(random.gaussian());
  std::vector<test::SurfacePoint> points;
  const Plane plane = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      double sum = 0.0;
      for (int k = 0; k < g * g; ++k) sum += numbers[static_cast<std::size_t>((row + k / g) * wide + column + k % g)];
      points.push_back({Vec3(column * kSpacing, row * kSpacing, 1.0 + kNoise * sum / g), plane.normal});
    }
  }
  Fit fit{*test::fitTo(points, plane, noise), {}};
  for (const test::SurfacePoint& p : points) fit.points.push_back(p.point);
  return fit;
}

/// In the mean.
SharedNoise sharedInGrains(int g, int side) {
  constexpr int kSeeds = 60;
  SharedNoise mean = {0.0, 0.0};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Random random(seed);
    const Fit fit = planeInGrains(g, side, random);
    const SharedNoise shared = measureSharedNoise(fit.shape, fit.points, noise);
    mean.shown += shared.shown / kSeeds, mean.all += shared.all / kSeeds;
  }
  return mean;
}

/// Of weights that fall off to three standard deviations, sums over grains grow by so much less than those of numbers.
constexpr double kOfWeights = 0.83;

TEST(SharedNoise, OfGrainsIsTheirPointsThoughCellsAreHardlyLarger) {
  for (const int g : {3, 5}) {
    const SharedNoise shared = sharedInGrains(g, 40);  // its cells are 7 by 7 points
    const double truth = kOfWeights * g * g;
    EXPECT_LT(shared.shown, 0.85 * truth) << g;
    EXPECT_GT(shared.all, 0.8 * truth) << g;
    EXPECT_LT(shared.all, 1.2 * truth) << g;
  }
}

TEST(SharedNoise, OfManyPointsOfWhichSomeAreAskedIsThatOfAll) {
  constexpr int kGrain = 5;
  const SharedNoise shared = sharedInGrains(kGrain, 80);  // of 6400 points a third, evenly taken
  const double truth = kOfWeights * kGrain * kGrain;
  EXPECT_LT(shared.shown, 0.85 * truth);
  EXPECT_GT(shared.all, 0.7 * truth);
  EXPECT_LT(shared.all, 1.2 * truth);
}

TEST(SharedNoise, IsOneWhereNothingCanBeSaid) {
  const Sphere sphere = {Vec3(0, 0, 1), 0.1};
  for (const std::size_t count : {0, 1, 100}) {
    EXPECT_EQ(measureSharedNoise(sphere, std::vector<Vec3>(count, Vec3(0, 0, 0.9)), noise).all, 1.0);
    EXPECT_EQ(measureSharedNoise(sphere, std::vector<Vec3>(count, Vec3(0, 0, 0.901)), noise).all, 1.0);
  }
}

TEST(SharedNoise, OfPointsOnALineIsMeasuredToo) {
  // As a row of exact pixels may be: how far they are apart across it is nothing but rounding.
  const Plane plane = {Vec3(0, 0, 1), Vec3(0.0, -0.6, -0.8)};
  Random random(1);
  std::vector<Vec3> points;
  for (int k = 0; k < 100; ++k) {
    const Vec3 rounding{0.0, random.uniform(-1e-9, 1e-9), random.uniform(-1e-9, 1e-9)};
    points.push_back(plane.point + Vec3(0.003 * k, 0, 0) + 0.3 * kNoise * plane.normal + rounding);
  }
  EXPECT_GE(measureSharedNoise(plane, points, noise).all, 1.0);  // threw: as many cells as no list holds
}

}  // namespace
}  // namespace primitect::shared_noise_test
