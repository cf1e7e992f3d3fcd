// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Storing points and normals: what counts as missing.
#include "primitect/cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "test/support/exact_shapes.h"
#include "test/support/wall_image.h"

namespace primitect::cloud_test {
namespace {

TEST(Cloud, TakesZeroAndNotFiniteAndOutOfRangeAsMissing) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float depths[][3] = {{0, 0, 0},     {kNan, 0, 1},  {0, kInfinity, 1}, {0, 0, kNan},
                             {0, 0, 2.01f}, {0, 0, 0.09f}, {0, 0, -1},        {3e38f, 0, 1}};
  Cloud cloud;
  cloud.reset(9, 1, false);
  for (std::size_t i = 0; i < 7; ++i) cloud.setPoint(i, depths[i][0], depths[i][1], depths[i][2], {0.1f, 2.0f});
  cloud.setPoint(7, 0.0f, 0.0f, 2.0f, {0.1f, 2.0f});
  cloud.setPoint(8, 1.0f, 0.0f, 0.1f, {0.1f, 2.0f});
  EXPECT_EQ(cloud.valid_count, 2u);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(cloud.valid(i), i >= 7) << i;
}

TEST(Cloud, RemembersWhatLayBeyondTheFarBound) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float depths[] = {1.0f, 2.01f, 5.0f, kInfinity, 0.05f, -3.0f, -kInfinity, std::nanf(""), -std::nanf("")};
  Cloud cloud;
  cloud.reset(9, 1, false);
  for (const float max : {2.0f, 0.0f}) {
    for (std::size_t i = 0; i < 9; ++i) cloud.setPoint(i, 0.1f, 0.0f, depths[i], {0.1f, max});
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(cloud.isBeyond(i), max > 0.0f && 1 <= i && i <= 3) << i << " " << max;
  }
}

TEST(Cloud, ChecksPointsInARowAsOneByOne) {
  const float values[] = {0.0f, 0.5f, -1.0f, 1e7f, -1e7f, 1e6f, std::nanf(""), std::numeric_limits<float>::infinity()};
  for (const DepthRange& range :
       {DepthRange{}, DepthRange{0.1f, 0.0f}, DepthRange{0.0f, 2.0f}, DepthRange{0.5f, 2.0f}}) {
    Cloud one_by_one, in_a_row;
    one_by_one.reset(8 * 8, 8, false);
    in_a_row.prepare(8 * 8, 8, false);
    for (std::size_t i = 0; i < 512; ++i) {
      const float x = values[i % 8], y = values[i / 8 % 8], z = values[i / 64];
      one_by_one.setPoint(i, x, y, z, range);
      in_a_row.x[i] = x, in_a_row.y[i] = y, in_a_row.z[i] = z;
    }
    in_a_row.checkPoints(0, 100, range);
    in_a_row.checkPoints(100, 512, range);
    EXPECT_EQ(in_a_row.valid_count, one_by_one.valid_count);
    EXPECT_EQ(in_a_row.behind_count, one_by_one.behind_count);
    EXPECT_EQ(in_a_row.behind_count > 0, range.min == 0.0f);
    for (std::size_t i = 0; i < 512; ++i) {
      ASSERT_EQ(std::isnan(in_a_row.x[i]), !one_by_one.valid(i)) << i;
      ASSERT_EQ(in_a_row.valid(i), one_by_one.valid(i)) << i;
      ASSERT_EQ(in_a_row.isBeyond(i), one_by_one.isBeyond(i)) << i;
      if (!in_a_row.valid(i)) continue;
      ASSERT_TRUE(in_a_row.x[i] == one_by_one.x[i] && in_a_row.z[i] == one_by_one.z[i]) << i;
    }
  }
}

TEST(Cloud, TakesPointsFromBytesOfAnyStepAndPlace) {
  constexpr std::size_t kCount = 37;  // no whole vectors
  const DepthRange range{0.1f, 2.0f};
  for (const std::size_t step : {12, 13, 16, 20, 32, 48}) {
    for (const std::size_t offset : {0, 1, 4}) {
      // The last point ends where the bytes end: nothing behind it may be read.
      std::vector<std::uint8_t> bytes(offset + (kCount - 1) * step + 3 * sizeof(float), 0xff);
      Cloud one_by_one, from_bytes;
      one_by_one.reset(kCount + 1, 1, false);
      from_bytes.reset(kCount + 1, 1, false);
      for (std::size_t i = 0; i < kCount; ++i) {
        const float point[] = {0.1f * i, -0.2f * i, i % 5 == 0 ? std::nanf("") : 0.06f * i};
        std::memcpy(bytes.data() + offset + i * step, point, sizeof point);
        one_by_one.setPoint(i + 1, point[0], point[1], point[2], range);
      }
      from_bytes.setPoints(1, kCount, bytes.data() + offset, step, range);
      EXPECT_EQ(from_bytes.valid_count, one_by_one.valid_count);
      EXPECT_GT(from_bytes.valid_count, 20u);
      for (std::size_t i = 0; i <= kCount; ++i) {
        ASSERT_EQ(from_bytes.valid(i), one_by_one.valid(i)) << "step " << step << ", point " << i;
        if (!from_bytes.valid(i)) continue;
        ASSERT_EQ(from_bytes.x[i], one_by_one.x[i]);
        ASSERT_EQ(from_bytes.y[i], one_by_one.y[i]);
        ASSERT_EQ(from_bytes.z[i], one_by_one.z[i]);
      }
    }
  }
}

TEST(Cloud, MovesPointsAndNormalsAndCutsWhereItGets) {
  Cloud cloud;
  cloud.reset(4, 1, true);
  cloud.setPoint(0, 1.0f, 2.0f, 3.0f, {});
  cloud.setPoint(2, 1.0f, 2.0f, 9.0f, {});
  cloud.setPoint(3, 0.0f, -6.0f, 0.0f, {});
  cloud.setNormal(0, 0.0f, 0.0f, 1.0f);
  // y ahead becomes z ahead, from 5 m farther back.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  pose.translation().z() = 5.0;
  cloud.move(pose, {0.0f, 7.0f});
  EXPECT_EQ(cloud.valid_count, 3u);
  EXPECT_EQ(cloud.behind_count, 1u);
  EXPECT_EQ(cloud.x[0], 1.0f);
  EXPECT_EQ(cloud.y[0], -3.0f);
  EXPECT_EQ(cloud.z[0], 7.0f);
  EXPECT_EQ(cloud.ny[0], -1.0f);
  EXPECT_EQ(cloud.nz[0], 0.0f);
  EXPECT_FALSE(cloud.valid(1));
  EXPECT_TRUE(std::isnan(cloud.nx[2]));
  EXPECT_EQ(cloud.z[3], -1.0f);
  cloud.move(Eigen::Isometry3d::Identity(), {0.0f, 6.0f});
  EXPECT_EQ(cloud.valid_count, 1u);
}

TEST(Cloud, LiesBehindWhereMoreThanOnePointInAHundredDoes) {
  Cloud cloud;
  EXPECT_FALSE(cloud.liesBehind()) << "no points";
  cloud.reset(300, 1, false);
  for (std::size_t i = 0; i < 200; ++i) cloud.setPoint(i, 0.1f, 0.0f, i < 2 ? -1.0f : 1.0f, {});
  EXPECT_FALSE(cloud.liesBehind());
  cloud.setPoint(200, 0.1f, 0.0f, -1.0f, {});
  EXPECT_TRUE(cloud.liesBehind()) << "of those that are measured";
}

/// Ten thousand points on a curve, of which every so-many-th is in one place.
Cloud filledIn(std::size_t every, float depth) {
  Cloud cloud;
  cloud.reset(10000, 1, false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool filled_in = i % every == 0;
    cloud.setPoint(i, filled_in ? 0.0f : 0.001f * static_cast<float>(i), 0.0f, filled_in ? depth : 1.0f, {});
  }
  cloud.dropFilledIn();
  return cloud;
}

TEST(Cloud, DropsAPlaceThatIsFilledIn) {
  const Cloud third = filledIn(3, 0.5f);
  EXPECT_EQ(third.valid_count, 6666u);
  EXPECT_FALSE(third.valid(0) || third.valid(3) || third.valid(9999));
  EXPECT_TRUE(third.valid(1) && third.valid(9998));
  EXPECT_EQ(filledIn(10, -1.0f).behind_count, 0u);
  EXPECT_EQ(filledIn(30, 0.5f).valid_count, 9666u);
  EXPECT_EQ(filledIn(200, 0.5f).valid_count, 10000u) << "that few may be a coincidence";
  EXPECT_EQ(filledIn(1, 0.5f).valid_count, 10000u) << "all of them";
}

TEST(Cloud, DropsAPlaceThatIsFilledInInSomeColumnsAlone) {
  for (const std::uint32_t first : {10u, 200u, 330u}) {
    Cloud image = test::wallImage(640, 480, 0.002f);
    for (std::size_t i = 0; i < image.size(); ++i) {
      const std::uint32_t column = static_cast<std::uint32_t>(i) % image.width;
      if (first <= column && column < first + 30) image.x[i] = image.y[i] = 0.0f, image.z[i] = 0.5f;
    }
    image.countPoints();
    image.dropFilledIn();
    EXPECT_FALSE(image.valid(100u * 640u + first + 15u)) << first;
    EXPECT_TRUE(image.valid(100u * 640u + first - 5u)) << first;
  }
}

TEST(Cloud, KeepsPointsThatCameTwice) {
  Cloud cloud;
  cloud.reset(1000, 1, false);
  for (std::size_t i = 0; i < 1000; ++i) cloud.setPoint(i, 0.002f * static_cast<float>(i / 2), 0.0f, 1.0f, {});
  cloud.dropFilledIn();
  EXPECT_EQ(cloud.valid_count, 1000u);
}

TEST(Cloud, IsConsistentWithListsAsLongAsItsSidesSay) {
  Cloud cloud;
  EXPECT_TRUE(cloud.isConsistent());
  cloud.reset(4, 3, true);
  EXPECT_TRUE(cloud.isConsistent());
  Cloud higher = cloud, shorter = cloud, part = cloud, without = cloud;
  higher.height = 4;
  shorter.z.pop_back();
  part.ny.clear();
  without.dropNormals();
  Cloud fewer_normals = cloud;
  fewer_normals.nx.pop_back();
  EXPECT_FALSE(fewer_normals.isConsistent());
  EXPECT_FALSE(higher.isConsistent());
  EXPECT_FALSE(shorter.isConsistent());
  EXPECT_FALSE(part.isConsistent());
  EXPECT_TRUE(without.isConsistent());
}

TEST(Cloud, KeepsAllDepthsWhenTheRangeIsOff) {
  Cloud cloud;
  cloud.reset(2, 1, false);
  cloud.setPoint(0, 0.0f, 1.0f, -50.0f, {});
  cloud.setPoint(1, 0.0f, 1.0f, 5000.0f, {});
  EXPECT_EQ(cloud.valid_count, 2u);
}

TEST(Cloud, ScalesNormalsAndDropsThoseWithoutDirection) {
  Cloud cloud;
  cloud.reset(3, 1, true);
  cloud.setNormal(0, 0.0f, 3.0f, 4.0f);
  cloud.setNormal(1, 0.0f, 0.0f, 0.0f);
  cloud.setNormal(2, std::numeric_limits<float>::infinity(), 0.0f, 0.0f);
  EXPECT_FLOAT_EQ(cloud.ny[0], 0.6f);
  EXPECT_TRUE(std::isnan(cloud.nx[1]) && std::isnan(cloud.nx[2]));
}

}  // namespace
}  // namespace primitect::cloud_test
