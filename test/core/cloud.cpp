// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Storing points and normals: what counts as missing.
#include "primitect/cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "test/support/exact_shapes.h"

namespace primitect {
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
}  // namespace primitect
