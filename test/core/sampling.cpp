// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Drawing samples: valid, spread, unique, repeatable.
#include "core/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
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
  drawSamples(cloud, {}, 1000, 1, samples);
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
  drawSamples(cloud, {}, 1000, 1, samples);
  EXPECT_EQ(samples.size(), 50u);
  Cloud empty;
  empty.reset(10, 10, false);
  drawSamples(empty, {}, 1000, 1, samples);
  EXPECT_EQ(samples.size(), 0u);
  EXPECT_EQ(boundingBoxDiagonal(samples), 0.0);
}

TEST(Sampling, LeavesOutThePointsThatHaveALabel) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  std::vector<std::uint32_t> labels(cloud.size(), 3);
  for (std::size_t i = 5000; i < 5100; ++i) labels[i] = 0;
  Samples samples;
  drawSamples(cloud, labels, 60, 1, samples);
  EXPECT_EQ(samples.size(), 60u);
  for (const std::uint32_t i : samples.index) EXPECT_TRUE(5000 <= i && i < 5100) << i;
  drawSamples(cloud, labels, 1000, 1, samples);
  EXPECT_EQ(samples.size(), 100u);
}

TEST(Sampling, DependsOnTheSeedAlone) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Samples a, b, c;
  drawSamples(cloud, {}, 500, 7, a);
  drawSamples(cloud, {}, 500, 7, b);
  drawSamples(cloud, {}, 500, 8, c);
  EXPECT_EQ(a.index, b.index);
  EXPECT_NE(a.index, c.index);
}

TEST(Sampling, PutsNeighborsInSpaceNearEachOtherInMemory) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Samples samples;
  drawSamples(cloud, {}, 1024, 1, samples);
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
