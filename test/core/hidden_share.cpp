// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Boards before boards.
#include "core/hidden_share.h"

#include <gtest/gtest.h>

#include <vector>

namespace primitect::hidden_share_test {
namespace {

using Point = Eigen::Vector3f;

/// Half a metre wide, across z.
std::vector<Point> board(float z, float x = 0.0f) {
  std::vector<Point> points;
  for (int i = -50; i < 50; ++i) {
    for (int k = -50; k < 50; ++k)
      points.emplace_back(x + 0.005f * static_cast<float>(i), 0.005f * static_cast<float>(k), z);
  }
  return points;
}

std::vector<Point> both(std::vector<Point> first, const std::vector<Point>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(HiddenShare, IsOfWhatLiesBehind) {
  // The nearer board hides, of one 1.5 times as far away, (1 / 1.5)^2 of what is as large.
  EXPECT_NEAR(hiddenShare(both(board(1.0f), board(1.5f)), Point::Zero(), Point::UnitZ()), 0.5, 0.02);
  EXPECT_LT(hiddenShare(both(board(1.0f), board(1.5f, 0.8f)), Point::Zero(), Point::UnitZ()), 0.01) << "beside it";
  EXPECT_LT(hiddenShare(board(1.0f), Point::Zero(), Point::UnitZ()), 0.01) << "alone";
}

TEST(HiddenShare, IsOfWhatLiesAsideOrBehindTheCamera) {
  EXPECT_EQ(hiddenShare(board(1.0f), Point::Zero(), -Point::UnitZ()), 1.0);
  EXPECT_NEAR(hiddenShare(both(board(1.0f), board(1.0f, 5.0f)), Point::Zero(), Point::UnitZ()), 0.5, 0.01);
}

TEST(HiddenShare, DoesNotDependOnTheScale) {
  std::vector<Point> points = both(board(1.0f), board(1.5f));
  const double share = hiddenShare(points, Point::Zero(), Point::UnitZ());
  for (Point& point : points) point *= 10.0f;
  EXPECT_NEAR(hiddenShare(points, Point::Zero(), Point::UnitZ()), share, 0.01);
}

TEST(HiddenShare, IsAllWhereNothingCanBeSaid) {
  EXPECT_EQ(hiddenShare({}, Point::Zero(), Point::UnitZ()), 1.0);
  EXPECT_EQ(hiddenShare(std::vector<Point>(100, Point::Zero()), Point::Zero(), Point::UnitZ()), 1.0);
  // A pixel for each would be some billions.
  std::vector<Point> narrow(20000, Point(0.0f, 0.0f, 1.0f));
  narrow.emplace_back(1.0f, 1.0f, 1.0f);
  narrow.emplace_back(-1.0f, -1.0f, 1.0f);
  EXPECT_EQ(hiddenShare(narrow, Point::Zero(), Point::UnitZ()), 1.0);
}

}  // namespace
}  // namespace primitect::hidden_share_test
