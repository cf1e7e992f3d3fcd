// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Images that were moved to another frame tell where their camera was.
#include "primitect/moved_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/random.h"
#include "synthetic/clutter.h"
#include "synthetic/poses.h"
#include "test/support/rendered_cloud.h"

namespace primitect::moved_image_test {
namespace {

/// Of a table, in the frame of the camera.
Cloud table(std::uint64_t seed) {
  return test::renderedCloud(synthetic::clutteredTable(seed), {}, seed, synthetic::clutterPose(seed));
}

Cloud moved(Cloud cloud, const Eigen::Isometry3d& frame_from_camera) {
  cloud.move(frame_from_camera, DepthRange());
  return cloud;
}

/// Poses of a camera on a robot and on a drone, and one that lies on its side.
std::vector<Eigen::Isometry3d> poses() {
  Eigen::Isometry3d on_side = Eigen::Isometry3d::Identity();
  on_side.translate(Vec3(-3.0, 20.0, 5.0)).rotate(Eigen::AngleAxisd(1.5, Vec3(1, 2, -1).normalized()));
  return {synthetic::robotFromCamera(1.3, 0.6), synthetic::robotFromCamera(2.5, 1.5), on_side,
          Eigen::Isometry3d::Identity()};
}

TEST(FindCamera, FromATableInAnyFrame) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Cloud cloud = table(seed);
    for (const Eigen::Isometry3d& pose : poses()) {
      const auto found = findCamera(moved(cloud, pose));
      ASSERT_TRUE(found) << seed;
      EXPECT_EQ(isAtOrigin(*found, cloud), pose.matrix().isIdentity());
      // What is left of a millimetre are the last digits of floats.
      EXPECT_LT((found->translation() - pose.translation()).norm(), 0.002) << seed;
      EXPECT_LT(Eigen::AngleAxisd(found->linear().transpose() * pose.linear()).angle(), 0.002) << seed;
    }
  }
}

TEST(SearchForCamera, IsSparedInTheFrameOfTheCamera) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const Eigen::Isometry3d& pose : poses()) {
      const Cloud cloud = moved(table(seed), pose);
      const bool at_origin = pose.matrix().isIdentity();
      const std::optional<CameraSearch> in_cut = searchForCameraInCut(cloud);
      EXPECT_EQ(in_cut.has_value(), at_origin) << "all of it must be looked at, table " << seed;
      EXPECT_EQ(in_cut && in_cut->at_origin, at_origin) << seed;
      const CameraSearch in_all = searchForCamera(cloud);
      EXPECT_EQ(in_all.at_origin, at_origin) << seed;
      EXPECT_EQ(in_all.cloud_from_camera.has_value(), !at_origin) << seed;
    }
  }
}

TEST(SearchForCamera, FindsOneThatWasMovedALittleOrOutOfTheRange) {
  Eigen::Isometry3d beside = Eigen::Isometry3d::Identity();
  beside.translate(Vec3(0.015, 0, 0));
  for (const Eigen::Isometry3d& pose : {beside, synthetic::robotFromCamera(0.3, 0.9)}) {
    Cloud cut = table(1);
    cut.move(pose, {0.1f, 2.0f});
    EXPECT_FALSE(searchForCameraInCut(cut)) << pose.translation().transpose();
    const auto found = searchForCamera(moved(table(1), pose)).cloud_from_camera;
    ASSERT_TRUE(found) << pose.translation().transpose();
    EXPECT_LT((found->translation() - pose.translation()).norm(), 0.002);
  }
}

TEST(FindCamera, WhateverAFewStraysSay) {
  Random random(3);
  const Eigen::Isometry3d pose = synthetic::robotFromCamera(1.3, 0.6);
  Cloud cloud = moved(table(1), pose);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i) || random.uniform(0.0, 1.0) > 0.02) continue;
    cloud.x[i] += 0.2f * static_cast<float>(random.gaussian());
  }
  const auto found = findCamera(cloud);
  ASSERT_TRUE(found);
  EXPECT_LT((found->translation() - pose.translation()).norm(), 0.002);
}

/// As a cloud whose missing points are at (0, 0, 0), moved with them.
TEST(FindCamera, WhereMissingPointsAreAtTheCamera) {
  const Eigen::Isometry3d pose = synthetic::robotFromCamera(1.3, 0.6);
  Cloud cloud = table(1);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 point = cloud.valid(i) && i % 5 > 0 ? Vec3(cloud.x[i], cloud.y[i], cloud.z[i]) : Vec3(0, 0, 0);
    const Vec3 there = pose * point;
    cloud.setPoint(i, static_cast<float>(there.x()), static_cast<float>(there.y()), static_cast<float>(there.z()), {});
  }
  const auto found = findCamera(cloud);
  ASSERT_TRUE(found);
  EXPECT_LT((found->translation() - pose.translation()).norm(), 0.002);
}

TEST(FindCamera, InAPartOfItsImageAndWhereRowsAreMissing) {
  const Eigen::Isometry3d pose = synthetic::robotFromCamera(1.3, 0.6);
  const Cloud image = moved(table(1), pose);
  const auto of = [&image](std::uint32_t first, std::uint32_t step) {
    Cloud part;
    part.reset(image.width, (image.height - first) / step, false);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::size_t from = (first + i / image.width * step) * image.width + i % image.width;
      part.setPoint(i, image.x[from], image.y[from], image.z[from], {});
    }
    return part;
  };
  for (const Cloud& part : {of(image.height / 2, 1), of(0, 4)}) {
    const auto found = findCamera(part);
    ASSERT_TRUE(found) << part.height;
    EXPECT_LT((found->translation() - pose.translation()).norm(), 0.004) << part.height;
  }
}

TEST(FindCamera, NotWhereColumnsAreRows) {
  const Cloud image = table(1);
  Cloud turned;  // by a quarter: rows of the image are columns of the cloud, which mirrors it
  turned.reset(image.height, image.width, false);
  for (std::size_t i = 0; i < image.size(); ++i) {
    turned.setPoint(i % image.width * image.height + i / image.width, image.x[i], image.y[i], image.z[i], {});
  }
  EXPECT_FALSE(findCamera(turned));
}

/// An image of places that a function of column and row gives.
template <class PlaceOf>
Cloud imageOf(const PlaceOf& placeOf) {
  Cloud cloud;
  cloud.reset(160, 120, false);
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const Vec3 p = placeOf(u, v);
      cloud.setPoint(static_cast<std::size_t>(160 * v + u), static_cast<float>(p.x()), static_cast<float>(p.y()),
                     static_cast<float>(p.z()), {});
    }
  }
  return cloud;
}

TEST(FindCamera, NotWhereNoCameraSawThem) {
  const auto depth = [](int u, int v) { return 1.0 + 0.3 * std::sin(0.1 * u) + 0.2 * std::cos(0.15 * v); };
  const auto pinhole = [&](double pixel, double middle) {
    return imageOf([&, pixel, middle](int u, int v) {
      return Vec3(Vec3((u - middle) * pixel, (v - 60) * pixel, 1.0) * depth(u, v) + Vec3(1, 2, 3));
    });
  };
  EXPECT_TRUE(findCamera(pinhole(1.0 / 130.0, 80.0)));
  EXPECT_FALSE(findCamera(pinhole(1.0 / 130.0, 255.0))) << "the axis is far from the image";
  EXPECT_FALSE(findCamera(imageOf([&](int u, int v) { return Vec3((u - 80) / 130.0, (v - 60) / 130.0, 1.0); })))
      << "a wall: any camera may have";
  EXPECT_FALSE(findCamera(imageOf([&](int u, int v) {
    const double azimuth = 0.01 * (u - 80), elevation = 0.01 * (v - 60);
    return Vec3(
        Vec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)) *
        depth(u, v));
  }))) << "a laser scanner";
  EXPECT_FALSE(findCamera(imageOf([&](int u, int v) {
    return Vec3(-(u - 80) / 130.0 * depth(u, v), (v - 60) / 130.0 * depth(u, v), depth(u, v));
  }))) << "a mirror";
  EXPECT_FALSE(findCamera(imageOf([&](int, int) { return Vec3(1, 2, 3); }))) << "one place";
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(findCamera(imageOf([&](int u, int v) {
    return u < 7 && v < 7 ? Vec3((u - 80) * depth(u, v), (v - 60) * depth(u, v), depth(u, v)) : Vec3(none, none, none);
  }))) << "few points";
}

}  // namespace
}  // namespace primitect::moved_image_test
