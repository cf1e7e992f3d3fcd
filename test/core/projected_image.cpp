// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Unorganized clouds and the image that they are put into.
#include "core/projected_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/random.h"
#include "test/support/exact_shapes.h"

namespace primitect::projected_image_test {
namespace {

using test::listOf;

/// Side by side in a square of this width (m), this far away.
std::vector<Vec3> square(int per_side, double width, double depth) {
  std::vector<Vec3> points;
  for (int row = 0; row < per_side; ++row) {
    for (int column = 0; column < per_side; ++column) {
      points.emplace_back(width * column / (per_side - 1), width * row / (per_side - 1), depth);
    }
  }
  return points;
}

TEST(ProjectedImage, HoldsPointsWhereTheyAreSeen) {
  const Cloud cloud = listOf(square(60, 0.6, 1.0));
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(cloud));
  const Cloud& image = projected.image();
  EXPECT_TRUE(image.organized());
  ASSERT_EQ(projected.pixel().size(), cloud.size());
  std::size_t held = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t pixel = projected.pixel()[i];
    ASSERT_LT(pixel, image.size());
    EXPECT_TRUE(image.valid(pixel));
    held += image.x[pixel] == cloud.x[i] && image.y[pixel] == cloud.y[i] ? 1 : 0;
    EXPECT_NEAR(image.x[pixel], cloud.x[i], 0.02);
  }
  EXPECT_EQ(held, image.valid_count);
  EXPECT_GT(held, cloud.size() / 2);
}

TEST(ProjectedImage, KeepsTheNearerOfTwoSurfaces) {
  for (const bool nearer_first : {true, false}) {
    std::vector<Vec3> points = square(40, 0.4, 1.0);
    const Vec3 nearer = 0.7 * points[410];
    const std::size_t place = nearer_first ? 0 : points.size();
    points.insert(nearer_first ? points.begin() : points.end(), nearer);
    const Cloud cloud = listOf(points);
    ProjectedImage projected;
    ASSERT_TRUE(projected.make(cloud));
    EXPECT_EQ(projected.image().z[projected.pixel()[place]], cloud.z[place]) << nearer_first;
  }
}

// As a voxel grid leaves them: ordered by depth, here and there with two points, one behind the other, where noise
// crosses the border of its cubes.
TEST(ProjectedImage, IsNeitherNearerNorFartherThanItsSurfaceWhateverTheOrder) {
  constexpr double kAway = 2e-3;
  const std::vector<Vec3> surface = square(60, 0.6, 1.0);
  for (const double first : {-kAway, kAway}) {
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < surface.size(); k += 3) points.push_back((1.0 + first) * surface[k]);
    for (std::size_t k = 0; k < surface.size(); ++k) {
      if (k % 3 != 0) points.push_back(surface[k]);
    }
    for (std::size_t k = 0; k < surface.size(); k += 3) points.push_back((1.0 - first) * surface[k]);
    ProjectedImage projected;
    ASSERT_TRUE(projected.make(listOf(points)));
    const Cloud& image = projected.image();
    double sum = 0.0;
    for (std::size_t i = 0; i < image.size(); ++i) sum += image.valid(i) ? image.z[i] : 0.0;
    EXPECT_GT(image.valid_count, 2400u);
    // With the first of two it would be a third of kAway. Of 1000 pairs four standard deviations are .08 mm.
    EXPECT_NEAR(sum / image.valid_count, 1.0, 2e-4) << first;
  }
}

TEST(ProjectedImage, IsNoneWhereATableHidesWhatStandsOnIt) {
  std::vector<Vec3> points = square(60, 0.6, 1.0);
  for (std::size_t k = 0; k < 3600; k += 20) points.push_back(1.1 * points[k]);
  ProjectedImage projected;
  EXPECT_FALSE(projected.make(listOf(points)));
  EXPECT_FALSE(projected.seenFromOrigin());
}

TEST(ProjectedImage, MayHaveEdgesThroughItsPixels) {
  std::vector<Vec3> points = square(60, 0.6, 1.0);
  for (std::size_t k = 0; k < 3600; ++k) {
    if (k % 60 >= 30) points[k] *= 1.3;
  }
  // What is farther away also lies in the last pixels of what is nearer.
  for (std::size_t row = 0; row < 60; ++row) points.push_back(1.3 * points[row * 60 + 29]);
  ProjectedImage projected;
  EXPECT_TRUE(projected.make(listOf(points)));
  EXPECT_TRUE(projected.seenFromOrigin());
}

TEST(ProjectedImage, IsAsFineAsThePointsAlsoWhereAFewLieFarAside) {
  std::vector<Vec3> points = square(60, 0.3, 1.0);
  points.emplace_back(-1.0, -1.0, 1.0);
  points.emplace_back(1.0, 1.0, 1.0);
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(listOf(points)));
  EXPECT_GT(projected.image().valid_count, points.size() / 2);
}

TEST(ProjectedImage, HoldsNoPlaceOfMissingPoints) {
  std::vector<Vec3> points = square(60, 0.6, 1.0);
  points.insert(points.begin() + 100, Vec3::Zero());
  const Cloud cloud = listOf(points);
  ASSERT_FALSE(cloud.valid(100));
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(cloud));
  EXPECT_EQ(projected.pixel()[100], ProjectedImage::kNoPixel);
  const std::vector<std::uint32_t> labels(projected.image().size(), 2);
  const List<std::size_t> counted = projected.pointsOfLabels(labels, 3);
  EXPECT_EQ(std::vector<std::size_t>(counted.begin(), counted.end()), (std::vector<std::size_t>{0, 3600, 0}));
}

TEST(ProjectedImage, IsAsFineAsTheRaysThatPointsShare) {
  for (const double width : {0.3, 0.9}) {
    // Alone, and where little of the view is filled.
    std::vector<Vec3> points = square(60, 0.3, 1.0);
    for (const Vec3& point : square(6, width, 1.0)) points.push_back(point);
    const std::vector<Vec3> once = points;
    for (const double nearness : {0.999, 1.001, 1.002}) {
      for (const Vec3& point : once) points.push_back(nearness * point);
    }
    ProjectedImage projected;
    ASSERT_TRUE(projected.make(listOf(points)));
    EXPECT_GT(projected.image().valid_count, once.size() / 2);
    EXPECT_LE(projected.image().valid_count, once.size());
    EXPECT_LT(projected.image().size(), once.size() * 20);
  }
}

TEST(ProjectedImage, IsNoLargerForAFewPointsFarAside) {
  std::vector<Vec3> points = square(200, 0.2, 1.0);
  const std::size_t in_square = points.size();
  for (int k = 0; k < 20; ++k) points.emplace_back(k % 2 == 0 ? 1.9 : -1.9, 0.19 * (k - 10), 1.0);
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(listOf(points)));
  EXPECT_LT(projected.image().size(), 4 * in_square);
  EXPECT_GT(projected.image().valid_count, in_square / 2);
  EXPECT_EQ(projected.pixel()[in_square], ProjectedImage::kNoPixel);
  EXPECT_NE(projected.pixel()[0], ProjectedImage::kNoPixel);
}

TEST(ProjectedImage, IsMadeOfAnImageOnlyWhereMostPixelsAroundItsPointsAreMissing) {
  const Cloud image = test::cameraCloud(Vec3(0.2, 0.0, 1.0).normalized(), 1.0);
  EXPECT_FALSE(ProjectedImage().make(image));
  const auto without = [&image](const auto& missing) {
    Cloud cloud = image;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (missing(i % 160, i / 160)) cloud.x[i] = cloud.y[i] = cloud.z[i] = std::numeric_limits<float>::quiet_NaN();
    }
    cloud.countPoints();
    return cloud;
  };
  EXPECT_FALSE(ProjectedImage().make(without([](std::size_t column, std::size_t) { return column > 12; }))) << "cut";
  const Cloud sparse = without([](std::size_t column, std::size_t row) { return column % 3 != 1 || row % 3 != 1; });
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(sparse));
  EXPECT_LT(projected.image().size(), sparse.size() / 4);
  EXPECT_GT(projected.image().valid_count, sparse.valid_count / 2);
}

TEST(ProjectedImage, IsNotMadeOfPointsAlongALine) {
  Random random(3);
  std::vector<Vec3> scan;
  for (int i = 0; i < 2000; ++i) scan.emplace_back(0.001 * i, 1e-12 * random.uniform(), 1.5);
  EXPECT_FALSE(ProjectedImage().make(listOf(scan)));
  for (Vec3& point : scan) point.y() = 0.0;
  EXPECT_FALSE(ProjectedImage().make(listOf(scan)));
}

TEST(ProjectedImage, IsNotMadeOfWhatNoCameraSeesFromOnePlace) {
  // Two walls, one behind the other, both as dense as if nothing hid the farther one.
  std::vector<Vec3> points = square(60, 0.6, 1.0);
  for (const Vec3& point : square(60, 1.2, 2.0)) points.push_back(point);
  EXPECT_FALSE(ProjectedImage().make(listOf(points)));
  for (const Vec3& unseen : {Vec3(0.0, 0.0, -1.0), Vec3(2.1, 0.0, 1.0)}) {
    points = square(60, 0.6, 1.0);
    points.insert(points.end(), points.size() / 1000, unseen);
    EXPECT_TRUE(ProjectedImage().make(listOf(points))) << "a few are strays";
    points.insert(points.end(), points.size() / 400, unseen);
    EXPECT_FALSE(ProjectedImage().make(listOf(points)));
  }
  EXPECT_FALSE(ProjectedImage().make(test::cameraCloud(Vec3::UnitZ(), 1.0)));
  EXPECT_FALSE(ProjectedImage().make(Cloud()));
}

}  // namespace
}  // namespace primitect::projected_image_test
