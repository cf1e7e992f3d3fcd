// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What is left of a large list to measure shapes on.
#include "core/thinned_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "test/support/wall_image.h"

namespace primitect::thinned_list_test {
namespace {

/// The same points one after the other, without order in an image.
Cloud flattened(Cloud cloud) {
  cloud.width *= cloud.height, cloud.height = 1;
  return cloud;
}

PointRuns someRunsOf(const Cloud& cloud) {
  PointRuns runs;
  findSomeRuns(cloud, runs);
  return runs;
}

TEST(ThinnedList, LeavesASmallOneWhole) {
  const Cloud points = flattened(test::wallImage(400, 400, 0.002f));
  ThinnedList thinned;
  thinned.begin(points, someRunsOf(points));
  EXPECT_FALSE(thinned.thinned());
  EXPECT_EQ(&thinned.cloud(), &points);
  EXPECT_EQ(thinned.each(), 1.0);
}

TEST(ThinnedList, OfALargeOneAreRunsOfIt) {
  const Cloud points = flattened(test::wallImage(2000, 1000, 0.001f));
  ThinnedList thinned;
  thinned.begin(points, someRunsOf(points));
  ASSERT_TRUE(thinned.thinned());
  const Cloud& part = thinned.cloud();
  EXPECT_FALSE(part.organized());
  EXPECT_GE(part.size(), 131072u);
  EXPECT_LE(part.size(), 262144u);
  EXPECT_EQ(part.valid_count, test::measuredIn(part));
  EXPECT_NEAR(thinned.each(), static_cast<double>(points.size()) / static_cast<double>(part.size()), 0.5);
  // From the first to the last of the wall.
  EXPECT_LT(part.y.front(), -0.49f);
  float last = part.y.front();
  for (const float y : part.y) last = y > last ? y : last;
  EXPECT_GT(last, 0.48f);
}

TEST(ThinnedList, LeavesSomethingOfEveryColumnOfAFlattenedImage) {
  const Cloud points = flattened(test::wallImage(640, 480, 0.002f, test::With::normals));
  ThinnedList thinned;
  thinned.begin(points, someRunsOf(points));
  ASSERT_TRUE(thinned.thinned());
  // Ten columns of 64 pixels, 480 rows of which half are left: binomial, with a standard deviation of 5 %.
  std::array<int, 10> in_column = {};
  for (const float x : thinned.cloud().x) {
    if (!std::isnan(x)) ++in_column[static_cast<std::size_t>(std::clamp((x / 0.002f + 320.0f) / 64.0f, 0.0f, 9.9f))];
  }
  for (const int count : in_column) EXPECT_NEAR(count, 432 * 64 / 2, 0.25 * 432 * 64 / 2);
}

TEST(ThinnedList, LeavesWholeWhatHasFewMeasuredPoints) {
  Cloud points = flattened(test::wallImage(2560, 1440, 0.0005f));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 20 != 0) test::dropPoint(i, points);
  }
  ThinnedList thinned;
  thinned.begin(points, someRunsOf(points));
  EXPECT_FALSE(thinned.thinned());
}

TEST(ThinnedList, OfTheNextFrameIsThatFrames) {
  const Cloud large = flattened(test::wallImage(1280, 720, 0.001f, test::With::normals));
  const Cloud larger = flattened(test::wallImage(2560, 1440, 0.0005f));
  ThinnedList thinned;
  thinned.begin(large, someRunsOf(large));
  ASSERT_TRUE(thinned.cloud().hasNormals());
  thinned.begin(larger, someRunsOf(larger));
  EXPECT_NEAR(thinned.each(), static_cast<double>(larger.valid_count) / thinned.cloud().valid_count, 1e-9);
  EXPECT_FALSE(thinned.cloud().hasNormals());
  thinned.keep(larger);
  EXPECT_FALSE(thinned.thinned());
}

}  // namespace
}  // namespace primitect::thinned_list_test
