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

#include "test/support/exact_shapes.h"

namespace primitect {
namespace {

using test::cameraCloud;
using test::patchOf;

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
  Sampler sampler;
  Samples samples;
  sampler.draw(cloud, &labels, 60, 1, samples);
  EXPECT_EQ(samples.size(), 60u);
  for (const std::uint32_t i : samples.index) EXPECT_TRUE(5000 <= i && i < 5100) << i;
  sampler.draw(cloud, &labels, 1000, 2, samples);
  EXPECT_EQ(samples.size(), 40u);
}

TEST(Sampling, SpreadsLaterRoundsOverWhatIsFree) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  const std::size_t first = 6400, free = 6400;
  std::vector<std::uint32_t> labels(cloud.size(), 1);
  std::fill_n(labels.begin() + first, free, 0u);
  Sampler sampler;
  Samples samples;
  sampler.draw(cloud, nullptr, 1000, 1, samples);
  sampler.draw(cloud, &labels, 1000, 2, samples);
  ASSERT_EQ(samples.size(), 1000u);
  int per_quarter[4] = {0, 0, 0, 0};
  for (const std::uint32_t i : samples.index) ++per_quarter[(i - first) * 4 / free];
  // The first round drew as many from each quarter, give or take one at its borders: that moves the runs a little.
  for (const int count : per_quarter) EXPECT_NEAR(count, 250, 3);
}

TEST(Sampling, DrawsNoPointTwiceAndInTheEndAllOfThem) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (std::size_t i = 0; i < cloud.size(); i += 5) cloud.z[i] = std::numeric_limits<float>::quiet_NaN();
  cloud.valid_count = static_cast<std::uint32_t>(cloud.size() * 4 / 5);
  std::vector<std::uint32_t> labels(cloud.size(), 0);
  Sampler sampler;
  std::set<std::uint32_t> drawn;
  for (int round = 0; round < 4; ++round) {
    Samples samples;
    sampler.draw(cloud, &labels, 4000, round, samples);
    EXPECT_EQ(samples.size(), round < 3 ? 4000u : 3360u);
    drawn.insert(samples.index.begin(), samples.index.end());
  }
  EXPECT_EQ(drawn.size(), cloud.valid_count);
}

TEST(Sampling, BeginsAnewWithEveryFrame) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Sampler sampler;
  Samples first, second;
  sampler.draw(cloud, nullptr, 15000, 1, first);
  sampler.begin();
  sampler.draw(cloud, nullptr, 15000, 1, second);
  EXPECT_EQ(first.index, second.index);
}

TEST(SpaceCurve, GoesFromCellToNeighborAndLeavesNoneOut) {
  constexpr std::uint32_t kSide = 8;
  std::vector<Vec3> cell_at(kSide * kSide * kSide, Vec3(-1, -1, -1));
  for (std::uint32_t x = 0; x < kSide; ++x) {
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t z = 0; z < kSide; ++z) {
        const std::uint32_t place = hilbertPlace(x, y, z);
        ASSERT_LT(place, cell_at.size());
        cell_at[place] = Vec3(x, y, z);
      }
    }
  }
  for (std::size_t k = 1; k < cell_at.size(); ++k) EXPECT_EQ((cell_at[k] - cell_at[k - 1]).norm(), 1.0) << k;
}

TEST(SpaceCurve, KeepsItsOrderBesideAPointFarAway) {
  Random random(32);
  std::vector<float> x, y, z;
  for (int i = 0; i < 1000; ++i) {
    x.push_back(static_cast<float>(random.uniform())), y.push_back(static_cast<float>(random.uniform()));
    z.push_back(1.0f);
  }
  x[500] = 1e5f;
  SpaceCurve curve;
  const std::vector<std::uint32_t>& order = curve.order(x, y, z);
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
}  // namespace primitect
