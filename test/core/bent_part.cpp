// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parts of a plane that the camera bends, and things that only look like it.
#include "core/bent_part.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/extent.h"
#include "primitect/detector.h"
#include "synthetic/frame.h"
#include "test/support/scenes.h"

namespace primitect::bent_part_test {
namespace {

using test::kDegree;

const NoiseModel kNoiseModel = {0.0, 0.002};

/// A wall 1 m before the camera.
Detection wall() {
  Detection detection;
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  detection.shape = plane;
  const std::vector<Vec3> points = {{-0.5, -0.4, 1.0}, {0.5, -0.4, 1.0}, {0.5, 0.4, 1.0}, {-0.5, 0.4, 1.0}};
  detection.extent = measureExtent(plane, points);
  detection.inlier_count = 200000;
  detection.truncated = kTruncatedByImage;
  return detection;
}

/// In the corner of that wall: a square with sides of `size` (m), whose side at x = 0.5 - size is `height` (m) before
/// the wall and which is turned about this side.
Detection corner(double tilt, double height = 0.0, double size = 0.1) {
  std::vector<Vec3> points;
  for (const double x : {0.0, size}) {
    for (const double y : {0.0, size}) {
      points.emplace_back(0.5 - size + x, 0.4 - size + y, 1.0 - height - std::tan(tilt) * x);
    }
  }
  Detection detection;
  const Plane plane = {points[0], Vec3(-std::sin(tilt), 0.0, -std::cos(tilt))};
  detection.shape = plane;
  detection.extent = measureExtent(plane, points);
  detection.inlier_count = 5000;
  detection.truncated = kTruncatedByImage;
  return detection;
}

TEST(BentPart, BeginsOnTheWholeAndLeavesIt) {
  EXPECT_TRUE(isBentPart(corner(6.0 * kDegree), wall(), kNoiseModel));
  EXPECT_TRUE(isBentPart(corner(-6.0 * kDegree), wall(), kNoiseModel)) << "behind it";
  EXPECT_FALSE(isBentPart(wall(), corner(6.0 * kDegree), kNoiseModel)) << "the other way round";
}

TEST(BentPart, BeginsInsideOfTheOutlineOrJustBesideIt) {
  const auto movedOutwards = [](double by) {
    Detection part = corner(6.0 * kDegree);
    for (Vec3& point : part.extent.hull) point.x() += 0.1 + by;  // its side that lies on the wall, from the rim on
    return part;
  };
  EXPECT_TRUE(isBentPart(movedOutwards(0.005), wall(), kNoiseModel));
  EXPECT_FALSE(isBentPart(movedOutwards(0.02), wall(), kNoiseModel));
  Detection bare = wall();
  bare.extent.hull.clear();
  EXPECT_FALSE(isBentPart(corner(6.0 * kDegree), bare, kNoiseModel)) << "there is no outline";
}

TEST(BentPart, IsNotWhatLiesFlatOrLeans) {
  EXPECT_FALSE(isBentPart(corner(3.0 * kDegree), wall(), kNoiseModel)) << "nearly flat";
  EXPECT_TRUE(isBentPart(corner(4.0 * kDegree), wall(), kNoiseModel));
  EXPECT_FALSE(isBentPart(corner(0.5 * kDegree, 0.004), wall(), kNoiseModel)) << "a plate";
  EXPECT_FALSE(isBentPart(corner(14.0 * kDegree), wall(), kNoiseModel)) << "steep";
  EXPECT_FALSE(isBentPart(corner(4.0 * kDegree, 0.010), wall(), kNoiseModel)) << "begins above it";
  EXPECT_FALSE(isBentPart(corner(9.0 * kDegree, 0.0, 0.18), wall(), kNoiseModel)) << "28 mm away from it";
}

TEST(BentPart, IsMuchSmallerAndAtTheRim) {
  Detection part = corner(6.0 * kDegree);
  part.inlier_count = 60000;
  EXPECT_FALSE(isBentPart(part, wall(), kNoiseModel)) << "large";
  part = corner(6.0 * kDegree);
  part.truncated = kTruncatedByOcclusion;
  EXPECT_FALSE(isBentPart(part, wall(), kNoiseModel)) << "inside of the image";
  part.truncated = kTruncationUnknown;
  EXPECT_FALSE(isBentPart(part, wall(), kNoiseModel)) << "perhaps inside of the image";
  EXPECT_TRUE(isBentPart(part, wall(), kNoiseModel, kTruncatedByImage | kTruncationUnknown)) << "where a list ends";
  part = corner(6.0 * kDegree);
  for (Vec3& point : part.extent.hull) point.x() += 0.2;
  EXPECT_FALSE(isBentPart(part, wall(), kNoiseModel)) << "beside it";
  part.shape = Sphere{Vec3(0.4, 0.3, 1.1), 0.1};
  EXPECT_FALSE(isBentPart(part, wall(), kNoiseModel)) << "no plane";
}

/// A table at 40 deg whose lower left corner the camera bends by 1.5 % of the depth.
Cloud bentTable() {
  const synthetic::PinholeCamera camera;
  const Plane table = {Vec3(0, 0, 0.9), Vec3(0.0, -std::sin(40.0 * kDegree), -std::cos(40.0 * kDegree))};
  std::vector<float> depth(camera.pixelCount());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const auto column = static_cast<double>(i % camera.width), row = static_cast<double>(i / camera.width);
    const double z = table.normal.dot(table.point) / table.normal.dot(camera.ray(column, row));
    const double inwards = std::hypot(column, camera.height - 1.0 - row) / 130.0;
    depth[i] = static_cast<float>(z * (1.0 + 0.015 * std::max(0.0, 1.0 - inwards)));
  }
  synthetic::NoiseParams noise;
  noise.max_incidence_deg = 90.0;
  addNoise(noise, camera, 3, 0, depth);
  Cloud cloud;
  cloudFromDepth(depth, camera, {}, cloud);
  return cloud;
}

TEST(BentPart, OfATableIsNotReported) {
  const Cloud cloud = bentTable();
  Params params;
  Detector detector{params};
  EXPECT_EQ(detector.detect(cloud).items.size(), 1u);
  Params without;
  without.left_out.add(Step::bent_parts);
  Detector believes_it{without};
  EXPECT_EQ(believes_it.detect(cloud).items.size(), 2u);
  params.min_confidence = 0.0;
  Detector shows_all{params};
  const std::vector<Detection> all = shows_all.detect(cloud).items;
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Detection& item) { return item.confidence == 0.0f; }));
}

TEST(BentPart, OfACloudThatNoDepthCameraTookIsAPlane) {
  const Cloud cloud = bentTable();
  Params params;
  params.inlier_depth_share = 0.0;
  Detector detector{params};
  EXPECT_EQ(detector.detect(cloud).items.size(), 2u);
}

}  // namespace
}  // namespace primitect::bent_part_test
