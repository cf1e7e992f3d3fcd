// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Drawing samples: valid, spread, unique, repeatable.
#include "core/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/point_runs.h"
#include "test/support/exact_shapes.h"

namespace primitect::sampling_test {
namespace {

using test::cameraCloud;
using test::patchOf;

/// Draws from all points of a cloud.
struct Draws {
  const Cloud& cloud;
  PointRuns runs;
  Sampler sampler;

  explicit Draws(const Cloud& of) : cloud(of) {
    findRuns(cloud, runs);
    sampler.begin(cloud, runs);
  }
  /// Only points without a label are free.
  void keepWithout(const std::vector<std::uint32_t>& labels) {
    List<std::uint64_t> bits(runs.size(), 0);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const std::size_t run = i / kernels::kPointsPerRun, place = i % kernels::kPointsPerRun;
      if (labels[runs.layout.point(run, place)] == 0) bits[run] |= std::uint64_t{1} << place;
    }
    sampler.keepTo(bits);
  }
  Samples draw(std::size_t count, std::uint64_t seed) {
    Samples samples;
    sampler.draw(count, seed, samples);
    return samples;
  }
};

TEST(Sampling, DrawsValidPointsOnceSpreadOverTheCloud) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (std::size_t i = 0; i < cloud.size(); i += 3) cloud.z[i] = std::numeric_limits<float>::quiet_NaN();
  cloud.valid_count =
      static_cast<std::uint32_t>(std::count_if(cloud.z.begin(), cloud.z.end(), [](float z) { return z == z; }));
  Samples samples;
  drawSamples(cloud, 1000, 1, samples);
  ASSERT_EQ(samples.size(), 1000u);
  std::set<std::uint32_t> unique(samples.index.begin(), samples.index.end());
  EXPECT_EQ(unique.size(), 1000u);
  int per_quarter[4] = {0, 0, 0, 0};
  for (const std::uint32_t i : samples.index) {
    EXPECT_TRUE(cloud.valid(i));
    ++per_quarter[i * 4 / cloud.size()];
  }
  for (const int count : per_quarter) EXPECT_NEAR(count, 250, 2);
}

TEST(Sampling, TakesAllPointsOfASmallCloudAndNoneOfAnEmptyOne) {
  Random random(31);
  const Cloud cloud = test::cloudOf(patchOf(Sphere{Vec3(0, 0, 1), 0.1}, 50, random));
  Samples samples;
  drawSamples(cloud, 1000, 1, samples);
  EXPECT_EQ(samples.size(), 50u);
  Cloud empty;
  empty.reset(10, 10, false);
  drawSamples(empty, 1000, 1, samples);
  EXPECT_EQ(samples.size(), 0u);
  EXPECT_EQ(boundingBoxDiagonal(samples), 0.0);
}

TEST(Sampling, LeavesOutThePointsThatHaveALabel) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  std::vector<std::uint32_t> labels(cloud.size(), 3);
  for (std::size_t i = 5000; i < 5100; ++i) labels[i] = 0;
  Draws draws(cloud);
  draws.keepWithout(labels);
  Samples samples = draws.draw(60, 1);
  EXPECT_EQ(samples.size(), 60u);
  for (const std::uint32_t i : samples.index) EXPECT_TRUE(5000 <= i && i < 5100) << i;
  draws.keepWithout(labels);
  EXPECT_EQ(draws.draw(1000, 2).size(), 40u);
}

TEST(Sampling, SpreadsLaterRoundsOverWhatIsFree) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  const std::size_t first = 6400, free = 6400;
  std::vector<std::uint32_t> labels(cloud.size(), 1);
  std::fill_n(labels.begin() + first, free, 0u);
  Draws draws(cloud);
  draws.draw(1000, 1);
  draws.keepWithout(labels);
  const Samples samples = draws.draw(1000, 2);
  ASSERT_EQ(samples.size(), 1000u);
  int per_quarter[4] = {0, 0, 0, 0};
  for (const std::uint32_t i : samples.index) ++per_quarter[(i - first) * 4 / free];
  // The first round drew as many from each quarter, give or take one at its borders: that moves the runs a little.
  for (const int count : per_quarter) EXPECT_NEAR(count, 250, 3);
}

/// How many points of the chosen runs are in each row, and in each column of 64 pixels, of an image whose pixels are
/// all measured.
struct ChosenRuns {
  std::size_t all, some;
  std::vector<double> in_row, in_column;

  ChosenRuns(std::uint32_t width, std::uint32_t height, bool flattened) {
    Cloud cloud;
    flattened ? cloud.reset(width * height, 1, false) : cloud.reset(width, height, false);
    cloud.valid_count = width * height;
    PointRuns runs, chosen;
    findRuns(cloud, runs);
    findSomeRuns(cloud, chosen);
    all = runs.size(), some = chosen.size();
    in_row.assign(height, 0.0), in_column.assign(width / kernels::kPointsPerRun, 0.0);
    for (const std::uint32_t run : chosen.number) {
      for (std::size_t place = 0; place < kernels::kPointsPerRun; ++place) {
        const std::size_t point = chosen.layout.point(run, place);
        in_row[point / width] += 1.0;
        in_column[point % width / kernels::kPointsPerRun] += 1.0;
      }
    }
  }
};

TEST(Sampling, ChoosesRunsOfEveryRowAndAllColumnsOfALargeImageAlsoOfAFlattenedOne) {
  for (const bool flattened : {false, true}) {
    const ChosenRuns chosen(1280, 960, flattened);
    EXPECT_EQ(chosen.some, chosen.all / 4);
    // Of the 1280 points in a row one of every four.
    for (const double count : chosen.in_row) EXPECT_EQ(count, 320.0);
    // Of the 960 runs in a column about a quarter: binomial, with a standard deviation of 13.
    for (const double count : chosen.in_column) EXPECT_NEAR(count / 64.0, 240.0, 65.0);
  }
}

TEST(Sampling, LooksAtNoMorePointsOfAVeryLargeImageThanOfALargeOne) {
  const ChosenRuns large(1280, 960, false), very_large(3072, 2048, false);
  EXPECT_EQ(large.some * kernels::kPointsPerRun, 307200u);
  EXPECT_EQ(very_large.some * kernels::kPointsPerRun, 262144u);
}

TEST(Sampling, LeavesOutNoneOfTheRunsOfAnImageWithFewMeasuredPoints) {
  Cloud cloud;
  cloud.reset(1280, 960, false);
  cloud.valid_count = 5000;
  PointRuns all, some;
  findRuns(cloud, all);
  findSomeRuns(cloud, some);
  EXPECT_EQ(some.size(), all.size());
}

TEST(Sampling, DrawsNoPointTwiceAndInTheEndAllOfThem) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (std::size_t i = 0; i < cloud.size(); i += 5) cloud.z[i] = std::numeric_limits<float>::quiet_NaN();
  cloud.valid_count = static_cast<std::uint32_t>(cloud.size() * 4 / 5);
  std::vector<std::uint32_t> labels(cloud.size(), 0);
  Draws draws(cloud);
  std::set<std::uint32_t> drawn;
  for (int round = 0; round < 4; ++round) {
    draws.keepWithout(labels);
    const Samples samples = draws.draw(4000, round);
    EXPECT_EQ(samples.size(), round < 3 ? 4000u : 3360u);
    drawn.insert(samples.index.begin(), samples.index.end());
  }
  EXPECT_EQ(drawn.size(), cloud.valid_count);
}

TEST(Sampling, FindsTheOnlyFreePointWhereverItIs) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Draws draws(cloud);
  for (std::size_t only = 0; only < 130; ++only) {
    std::vector<std::uint32_t> labels(cloud.size(), 1);
    labels[only] = 0;
    draws.keepWithout(labels);
    const Samples samples = draws.draw(10, only);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples.index[0], only);
  }
}

TEST(Sampling, BeginsAnewWithEveryFrame) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Draws draws(cloud);
  const Samples first = draws.draw(15000, 1);
  draws.sampler.begin(cloud, draws.runs);
  const Samples second = draws.draw(15000, 1);
  EXPECT_EQ(first.index, second.index);
}

TEST(SpaceCurve, GoesFromCellToNeighborAndLeavesNoneOut) {
  constexpr std::size_t kSide = 8, kCells = kSide * kSide * kSide;
  List<float> x, y, z;
  for (std::size_t k = 0; k < kCells; ++k) {
    x.push_back(static_cast<float>(k / kSide / kSide) + 0.5f),
        y.push_back(static_cast<float>(k / kSide % kSide) + 0.5f);
    z.push_back(static_cast<float>(k % kSide) + 0.5f);
  }
  for (const kernels::Loops* table : kernels::allLoops()) {
    List<std::uint32_t> place(kCells);
    table->places({{0.0f, 0.0f, 0.0f}, 1.0f}, x.data(), y.data(), z.data(), kCells, place.data());
    std::vector<Vec3> cell_at(kCells, Vec3(-1, -1, -1));
    for (std::size_t k = 0; k < kCells; ++k) {
      ASSERT_LT(place[k], kCells);
      cell_at[place[k]] = Vec3(x[k], y[k], z[k]);
    }
    for (std::size_t k = 1; k < kCells; ++k) EXPECT_EQ((cell_at[k] - cell_at[k - 1]).norm(), 1.0) << k;
  }
}

TEST(SpaceCurve, KeepsItsOrderBesideAPointFarAway) {
  Random random(32);
  List<float> x, y, z;
  for (int i = 0; i < 1000; ++i) {
    x.push_back(static_cast<float>(random.uniform())), y.push_back(static_cast<float>(random.uniform()));
    z.push_back(1.0f);
  }
  x[500] = 1e5f;
  SpaceCurve curve;
  const List<std::uint32_t>& order = curve.order(x, y, z);
  ASSERT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), 1000u);
  double step = 0.0;
  for (std::size_t k = 1; k < 999; ++k) {
    if (order[k] == 500 || order[k - 1] == 500) continue;
    step += std::hypot(x[order[k]] - x[order[k - 1]], y[order[k]] - y[order[k - 1]]) / 998.0;
  }
  // A thousand points on a square metre are 32 mm apart; without any order 0.5 m.
  EXPECT_LT(step, 0.06);
}

TEST(Sampling, DependsOnTheSeedAlone) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Samples a, b, c;
  drawSamples(cloud, 500, 7, a);
  drawSamples(cloud, 500, 7, b);
  drawSamples(cloud, 500, 8, c);
  EXPECT_EQ(a.index, b.index);
  EXPECT_NE(a.index, c.index);
}

TEST(Sampling, PutsNeighborsInSpaceNearEachOtherInMemory) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Samples samples;
  drawSamples(cloud, 1024, 1, samples);
  double step = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) step += (samples.point(i) - samples.point(i - 1)).norm() / 1023.0;
  // 1024 samples on 1.14 m x 0.86 m are 31 mm apart; in raster order the mean step would be a third of a row, 380 mm.
  EXPECT_LT(step, 0.08);
}

TEST(Sampling, MeasuresTheBoundingBox) {
  Samples samples = test::samplesOf({{Vec3(0, 0, 0), Vec3::UnitX()}, {Vec3(1, 2, 2), Vec3::UnitX()}});
  EXPECT_NEAR(boundingBoxDiagonal(samples), 3.0, 1e-6);
}

}  // namespace
}  // namespace primitect::sampling_test
