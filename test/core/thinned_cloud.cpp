// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What is left of a large cloud to measure shapes on.
#include "core/thinned_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/image_rays.h"

namespace primitect {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

/// A wall 1 m in front of a camera whose pixels are `pitch` apart at 1 m; every tenth row is missing.
Cloud wall(std::uint32_t width, std::uint32_t height, float pitch, bool with_normals) {
  Cloud cloud;
  cloud.reset(width, height, with_normals);
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      if (row % 10 == 9) continue;
      const std::size_t i = static_cast<std::size_t>(row) * width + column;
      cloud.setPoint(i, pitch * (static_cast<float>(column) - 0.5f * static_cast<float>(width)),
                     pitch * (static_cast<float>(row) - 0.5f * static_cast<float>(height)), 1.0f, {});
      if (with_normals) cloud.setNormal(i, 0.0f, 0.0f, -1.0f);
    }
  }
  return cloud;
}

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

std::uint32_t measuredOf(const Cloud& cloud) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) count += cloud.valid(i) ? 1 : 0;
  return count;
}

TEST(ThinnedCloud, LeavesASmallOneWhole) {
  const Cloud image = wall(640, 480, 0.002f, false), points = flattened(wall(400, 400, 0.002f, false));
  for (const Cloud* cloud : {&image, &points}) {
    ThinnedCloud thinned;
    thinned.begin(*cloud, someRunsOf(*cloud));
    EXPECT_FALSE(thinned.thinned());
    EXPECT_EQ(&thinned.cloud(), cloud);
    EXPECT_EQ(thinned.step(), 1);
    EXPECT_EQ(thinned.each(), 1.0);
  }
}

TEST(ThinnedCloud, OfALargeImageIsEverySecondColumnAndRow) {
  const Cloud image = wall(1281, 721, 0.001f, true);
  ThinnedCloud thinned;
  thinned.begin(image, someRunsOf(image));
  ASSERT_TRUE(thinned.thinned());
  const Cloud& part = thinned.cloud();
  EXPECT_EQ(thinned.step(), 2);
  ASSERT_EQ(part.width, 641u);
  ASSERT_EQ(part.height, 361u);
  EXPECT_EQ(part.valid_count, measuredOf(part));
  EXPECT_NEAR(thinned.each() * part.valid_count, image.valid_count, 1e-6 * image.valid_count);
  ASSERT_TRUE(part.hasNormals());
  for (std::size_t i = 0; i < part.size(); i += 97) {
    const std::size_t whole = 2 * (i / part.width) * image.width + 2 * (i % part.width);
    ASSERT_EQ(part.valid(i), image.valid(whole)) << i;
    if (!part.valid(i)) continue;
    ASSERT_EQ(part.x[i], image.x[whole]) << i;
    ASSERT_EQ(part.y[i], image.y[whole]) << i;
    ASSERT_EQ(part.nz[i], -1.0f) << i;
  }
}

TEST(ThinnedCloud, OfALargeCloudWithoutOrderAreRunsOfIt) {
  const Cloud points = flattened(wall(2000, 1000, 0.001f, false));
  ThinnedCloud thinned;
  thinned.begin(points, someRunsOf(points));
  ASSERT_TRUE(thinned.thinned());
  const Cloud& part = thinned.cloud();
  EXPECT_FALSE(part.organized());
  EXPECT_GE(part.size(), 131072u);
  EXPECT_LE(part.size(), 262144u);
  EXPECT_EQ(part.valid_count, measuredOf(part));
  EXPECT_NEAR(thinned.each(), static_cast<double>(points.size()) / static_cast<double>(part.size()), 0.5);
  // From the first to the last of the wall.
  EXPECT_LT(part.y.front(), -0.49f);
  float last = part.y.front();
  for (const float y : part.y) last = y > last ? y : last;
  EXPECT_GT(last, 0.48f);
}

TEST(ThinnedCloud, LeavesSomethingOfEveryColumnOfAFlattenedImage) {
  const Cloud points = flattened(wall(640, 480, 0.002f, true));
  ThinnedCloud thinned;
  thinned.begin(points, someRunsOf(points));
  ASSERT_TRUE(thinned.thinned());
  // Ten columns of 64 pixels, 480 rows of which half are left: binomial, with a standard deviation of 5 %.
  std::array<int, 10> in_column = {};
  for (const float x : thinned.cloud().x) {
    if (!std::isnan(x)) ++in_column[static_cast<std::size_t>(std::clamp((x / 0.002f + 320.0f) / 64.0f, 0.0f, 9.9f))];
  }
  for (const int count : in_column) EXPECT_NEAR(count, 432 * 64 / 2, 0.25 * 432 * 64 / 2);
}

TEST(ThinnedCloud, LeavesWholeWhatHasFewMeasuredPoints) {
  Cloud image = wall(2560, 1440, 0.0005f, false);
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (i % 20 != 0 && image.valid(i)) image.x[i] = image.y[i] = image.z[i] = kMissing, --image.valid_count;
  }
  const Cloud points = flattened(image);
  const Cloud* const clouds[] = {&image, &points};
  for (const Cloud* cloud : clouds) {
    ThinnedCloud thinned;
    thinned.begin(*cloud, someRunsOf(*cloud));
    EXPECT_FALSE(thinned.thinned());
  }
}

TEST(ThinnedCloud, StaysWholeWhereHolesHaveThePatternOfWhatIsLeft) {
  // Half of its points are enough for every second column, of which none was measured.
  Cloud image = wall(1600, 1200, 0.001f, false);
  for (std::size_t i = 0; i < image.size(); i += 2) {
    if (image.valid(i)) image.x[i] = image.y[i] = image.z[i] = kMissing, --image.valid_count;
  }
  ThinnedCloud thinned;
  thinned.begin(image, someRunsOf(image));
  EXPECT_FALSE(thinned.thinned());
  EXPECT_EQ(thinned.step(), 1);
  EXPECT_EQ(&thinned.cloud(), &image);
}

TEST(ThinnedCloud, OfTheNextFrameIsThatFrames) {
  const Cloud large = wall(1280, 720, 0.001f, true), larger = wall(2560, 1440, 0.0005f, false);
  ThinnedCloud thinned;
  thinned.begin(large, someRunsOf(large));
  thinned.begin(larger, someRunsOf(larger));
  EXPECT_EQ(thinned.step(), 4);
  EXPECT_EQ(thinned.cloud().width, 640u);
  EXPECT_FALSE(thinned.cloud().hasNormals());
  thinned.keep(larger);
  EXPECT_FALSE(thinned.thinned());
}

TEST(ThinnedCloud, HasTheRaysOfTheImage) {
  Cloud image = wall(1282, 722, 0.001f, false);
  // What lies beside the sensor's view.
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (i % image.width < 3 || i % image.width >= image.width - 4) image.z[i] = kMissing;
  }
  const ImageRays whole = findRays(image), rays = everySoMany(2, whole);
  ThinnedCloud thinned;
  thinned.begin(image, someRunsOf(image));
  const ImageRays found = findRays(thinned.cloud());
  ASSERT_TRUE(found.known);
  ASSERT_TRUE(rays.known);
  for (const int column : {0, 300, 640}) {
    for (const int row : {0, 200, 360})
      EXPECT_LT((rays.through(column, row) - found.through(column, row)).norm(), 1e-5);
  }
  EXPECT_EQ(rays.first_column, found.first_column);
  EXPECT_EQ(rays.last_column, found.last_column);
  EXPECT_EQ(rays.first_row, found.first_row);
  EXPECT_EQ(rays.last_row, found.last_row);
}

}  // namespace
}  // namespace primitect
