// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a large image is worked on as.
#include "core/thinned_image.h"

#include <gtest/gtest.h>

#include "core/image_rays.h"
#include "primitect/image_step.h"
#include "test/support/wall_image.h"

namespace primitect::thinned_image_test {
namespace {

TEST(ImageStep, LeavesEnoughPixelsColumnsAndRows) {
  EXPECT_EQ(largestImageStep(640, 480), 1);
  EXPECT_EQ(largestImageStep(1280, 719), 1);
  EXPECT_EQ(largestImageStep(1280, 720), 2);
  EXPECT_EQ(largestImageStep(1920, 1080), 3);
  EXPECT_EQ(largestImageStep(2560, 1440), 4);
  EXPECT_EQ(largestImageStep(4096, 479), 1) << "a wide strip has no rows to spare";
  EXPECT_EQ(largestImageStep(100000, 16), 1) << "a list in rows";
  EXPECT_EQ(largestImageStep(0, 0), 1);
}

TEST(ImageStep, BecomesSmallerUntilEnoughPointsAreMeasured) {
  EXPECT_EQ(imageStepFor(4, 131072), 4);
  EXPECT_EQ(imageStepFor(4, 131071), 3);
  EXPECT_EQ(imageStepFor(4, 131072 / 4), 2);
  EXPECT_EQ(imageStepFor(4, 0), 1);
  EXPECT_EQ(imageStepFor(1, 0), 1);
}

TEST(ThinnedImage, LeavesSmallOnesAndListsWhole) {
  Cloud cloud = test::wallImage(640, 480, 0.002f);
  ThinnedImage thinned;
  EXPECT_EQ(&thinned.of(cloud), &cloud);
  cloud = test::wallImage(2560, 1440, 0.0005f);
  cloud.width *= cloud.height, cloud.height = 1;
  EXPECT_EQ(&thinned.of(cloud), &cloud);
}

TEST(ThinnedImage, HasEverySecondColumnAndRow) {
  const Cloud image = test::wallImage(1281, 721, 0.001f, test::With::normals);
  ThinnedImage thinned;
  const Cloud& part = thinned.of(image);
  EXPECT_EQ(part.step, 2u);
  ASSERT_EQ(part.width, 641u);
  ASSERT_EQ(part.height, 361u);
  EXPECT_EQ(part.valid_count, test::measuredIn(part));
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

TEST(ThinnedImage, LeavesWholeWhatHasFewMeasuredPoints) {
  Cloud image = test::wallImage(2560, 1440, 0.0005f);
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (i % 21 != 0) test::dropPoint(i, image);  // of each column and row some
  }
  ThinnedImage thinned;
  EXPECT_EQ(&thinned.of(image), &image);
}

TEST(ThinnedImage, StaysWholeWhereHolesHaveThePatternOfWhatIsLeft) {
  // Half of its points would be enough, but of every second column none was measured.
  Cloud image = test::wallImage(1600, 1200, 0.001f);
  for (std::size_t i = 0; i < image.size(); i += 2) test::dropPoint(i, image);
  ThinnedImage thinned;
  EXPECT_EQ(&thinned.of(image), &image);
}

TEST(ThinnedImage, OfTheNextFrameIsThatFrames) {
  const Cloud large = test::wallImage(1280, 720, 0.001f, test::With::normals);
  const Cloud larger = test::wallImage(2560, 1440, 0.0005f);
  ThinnedImage thinned;
  ASSERT_TRUE(thinned.of(large).hasNormals());
  const Cloud& part = thinned.of(larger);
  EXPECT_EQ(part.step, 4u);
  EXPECT_EQ(part.width, 640u);
  EXPECT_FALSE(part.hasNormals());
}

TEST(ThinnedImage, OfOneThatWasReadInPartsHasTheStepsOfBoth) {
  Cloud image = test::wallImage(2560, 1440, 0.0005f);
  image.step = 3;
  ThinnedImage thinned;
  EXPECT_EQ(thinned.of(image).step, 12u);
}

TEST(ThinnedImage, HasTheRaysOfTheImage) {
  const Cloud image = test::wallImage(1282, 722, 0.001f);
  ThinnedImage thinned;
  const ImageRays whole = findRays(image), rays = findRays(thinned.of(image));
  ASSERT_TRUE(whole.known);
  ASSERT_TRUE(rays.known);
  for (const int column : {0, 300, 640}) {
    for (const int row : {0, 200, 360})
      EXPECT_LT((rays.through(column, row) - whole.through(2 * column, 2 * row)).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace primitect::thinned_image_test
