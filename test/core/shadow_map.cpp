// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A box on a table whose shadow is known.
#include "core/shadow_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace primitect::shadow_map_test {
namespace {

using Point = Eigen::Vector3f;

const Ground kTable{Point::UnitZ(), 0.0f};
const Point kLamp(0.3f, -0.8f, 0.9f);  // m

/// Of the top of a box, 10 cm high, and of a table of a square metre what is not in its shadow.
std::vector<Point> litBy(const Point& lamp) {
  constexpr float kStep = 0.004f, kHeight = 0.1f, kHalf = 0.06f;
  std::vector<Point> points;
  for (int i = -125; i <= 125; ++i) {
    for (int k = -125; k <= 125; ++k) {
      const Point on_table(kStep * static_cast<float>(i), kStep * static_cast<float>(k), 0.0f);
      // Where light on its way to the table passes the height of the box's top.
      const Point at_top = on_table + (kHeight / lamp.z()) * (lamp - on_table);
      if (at_top.head<2>().cwiseAbs().maxCoeff() > kHalf) points.push_back(on_table);
      if (on_table.head<2>().cwiseAbs().maxCoeff() <= kHalf) points.push_back(on_table + kHeight * Point::UnitZ());
    }
  }
  return points;
}

TEST(ShadowMap, FitsTheLampThatCastTheShadow) {
  ShadowMap shadows(kTable, litBy(kLamp));
  ASSERT_TRUE(shadows.isWorthASearch());
  const auto misfitAt = [&shadows](const Point& place) {
    return shadows.misfit(shadows.inFrameOfGround(place), ShadowMap::kMostStanding);
  };
  const float right = misfitAt(kLamp);
  EXPECT_LT(right, 0.1f);
  for (const Point& step : {Point(0.2f, 0.0f, 0.0f), Point(0.0f, 0.2f, 0.0f), Point(0.0f, 0.0f, 0.3f)}) {
    EXPECT_GT(misfitAt(kLamp + step), right + 0.1f) << step.transpose();
    EXPECT_GT(misfitAt(kLamp - step), right + 0.1f) << step.transpose();
  }
  EXPECT_FLOAT_EQ(misfitAt(kLamp), right) << "asked again";
}

TEST(ShadowMap, HasNoHoleWithoutShadows) {
  std::vector<Point> all = litBy(kLamp);
  for (int i = -125; i <= 125; ++i) {
    for (int k = -125; k <= 125; ++k)
      all.emplace_back(0.004f * static_cast<float>(i), 0.004f * static_cast<float>(k), 0.0f);
  }
  EXPECT_FALSE(ShadowMap(kTable, all).isWorthASearch());
}

TEST(ShadowMap, LeavesAloneWhatStandsBesideThePlane) {
  std::vector<Point> points = litBy(kLamp);
  for (Point& point : points) {
    if (point.z() > kAboveGround) point.x() += 2.0f;
  }
  EXPECT_FALSE(ShadowMap(kTable, points).isWorthASearch());
}

TEST(ShadowMap, IsOfThePartOfThePlaneWhereMostIs) {
  std::vector<Point> points = litBy(kLamp);
  points.emplace_back(90.0f, 0.0f, 0.0f);
  points.emplace_back(0.0f, -1e5f, 0.0f);
  ShadowMap shadows(kTable, points);
  ASSERT_TRUE(shadows.isWorthASearch());
  EXPECT_LT(shadows.misfit(shadows.inFrameOfGround(kLamp), ShadowMap::kMostStanding), 0.1f);
}

TEST(ShadowMap, OfNothingIsNotWorthASearch) { EXPECT_FALSE(ShadowMap(kTable, {}).isWorthASearch()); }

}  // namespace
}  // namespace primitect::shadow_map_test
