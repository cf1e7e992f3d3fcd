// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What cameras of other kinds than structured light make of simple scenes: flying pixels, blots, noise in grains.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/flying_pixels.h"
#include "primitect/detector.h"
#include "synthetic/sensors.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect {
namespace {

synthetic::FrameParams seenBy(const std::string& sensor) {
  synthetic::FrameParams params;
  params.noise = synthetic::noiseOf(sensor);
  return params;
}

Detections foundIn(const Cloud& cloud) {
  Detector detector{Params()};
  return detector.detect(cloud);
}

Cloud ballBeforeWall(int footprint, std::uint64_t seed) {
  synthetic::FrameParams params = seenBy("time_of_flight");
  params.noise.footprint = footprint;
  synthetic::World world;
  world.add("ball", synthetic::Ball{0.09}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.7)));
  world.add("wall", synthetic::Sheet{2.0, 2.0}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.9)));
  return test::renderedCloud(world, params, seed);
}

/// All around a ball they lie on the cone that its outline and the camera make.
TEST(OtherSensors, FlyingPixelsAroundABallAreNoCone) {
  for (const int footprint : {3, 5}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      int balls = 0, others = 0;
      for (const Detection& item : foundIn(ballBeforeWall(footprint, seed)).items) {
        const Kind kind = kindOf(item.shape);
        balls += kind == Kind::sphere ? 1 : 0;
        others += kind == Kind::cone || kind == Kind::cylinder ? 1 : 0;
      }
      EXPECT_EQ(balls, 1) << "footprint " << footprint << ", seed " << seed;
      EXPECT_EQ(others, 0) << "footprint " << footprint << ", seed " << seed;
    }
  }
}

/// A wall that is seen as steeply, of a few columns, and of many.
TEST(OtherSensors, OnlyNarrowSlopesAreFlyingPixels) {
  const synthetic::PinholeCamera camera;
  constexpr double kSlope = 10.0;  // depth over width: seen at less than 6 deg
  constexpr int kMiddle = 320, kRow = 240;
  const auto flies = [&](int columns) {
    std::vector<float> depth(camera.pixelCount());
    const double at_middle = (kMiddle - camera.cx) / camera.fx;
    for (std::size_t i = 0; i < depth.size(); ++i) {
      const int column = std::clamp(static_cast<int>(i % 640), kMiddle - columns / 2, kMiddle + columns / 2);
      // x = (z - 1) / slope + middle
      depth[i] = static_cast<float>((1.0 - kSlope * at_middle) / (1.0 - kSlope * (column - camera.cx) / camera.fx));
    }
    Cloud cloud;
    cloudFromDepth(depth, camera, DepthRange(), cloud);
    const Vec3 normal = Vec3(kSlope, 0.0, -1.0).normalized();
    const ImageRays rays = findRays(cloud);
    EXPECT_TRUE(rays.known);
    return fliesBetween(cloud, rays, kRow * 640 + kMiddle, normal, 1.0);
  };
  EXPECT_TRUE(flies(2));
  EXPECT_TRUE(flies(4));
  EXPECT_FALSE(flies(20));
}

/// A fifth of the image is lost in blots of ten pixels and more, as on dark and glossy cans.
TEST(OtherSensors, CansWithBlotsAreFound) {
  constexpr double kRadius = 0.04, kHeight = 0.12;  // m
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    synthetic::FrameParams params;
    params.noise.blots = 0.2;
    const Eigen::Isometry3d table = test::tableBeforeCamera(0.7, 37.0 * test::kDegree);
    synthetic::World world;
    world.add("table", synthetic::Sheet{1.0, 0.6}, table);
    world.add("can", synthetic::Rod{kRadius, 0.5 * kHeight}, table * Eigen::Translation3d(0.0, 0.0, 0.5 * kHeight));
    const Detections all = foundIn(test::renderedCloud(world, params, seed));
    found += std::any_of(all.items.begin(), all.items.end(), [](const Detection& item) {
      const Cylinder* can = std::get_if<Cylinder>(&item.shape);
      return can && std::abs(can->radius - kRadius) < 0.003;
    });
  }
  EXPECT_EQ(found, 12) << "2 where every blot speaks against a can";
}

/// Noise that 7 x 7 pixels share turns normals there by 20 deg and more.
TEST(OtherSensors, AStereoCameraSeesTheWallBehindTheTable) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Eigen::Isometry3d table = test::tableBeforeCamera(0.9, 30.0 * test::kDegree);
    synthetic::World world;
    world.add("table", synthetic::Sheet{1.0, 0.4}, table);
    world.add("wall", synthetic::Sheet{2.0, 2.0}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 1.75)));
    const Detections all = foundIn(test::renderedCloud(world, seenBy("stereo"), seed));
    found += std::any_of(all.items.begin(), all.items.end(), [](const Detection& item) {
      const Plane* plane = std::get_if<Plane>(&item.shape);
      return plane && plane->normal.z() < -0.99 && std::abs(plane->point.z() - 1.75) < 0.03 &&
             item.inlier_count > 50000;
    });
  }
  EXPECT_GE(found, 10);
}

}  // namespace
}  // namespace primitect
