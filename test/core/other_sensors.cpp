// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What cameras of other kinds than structured light make of simple scenes: flying pixels, blots, noise in grains.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/flying_pixels.h"
#include "primitect/detector.h"
#include "synthetic/sensors.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::other_sensors_test {
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

struct BallBeforeWall {
  double radius, distance, gap;  ///< m, gap: between ball and wall
  int footprint;                 ///< px

  Cloud seen(std::uint64_t seed) const {
    synthetic::FrameParams params = seenBy("time_of_flight");
    params.noise.footprint = footprint;
    synthetic::World world;
    world.add("ball", synthetic::Ball{radius}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, distance)));
    world.add("wall", synthetic::Sheet{4.0, 4.0},
              Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, distance + radius + gap)));
    return test::renderedCloud(world, params, seed);
  }
};

/// All around a ball they lie on the cone that its outline and the camera make: five of these frames have some if they
/// are taken for samples.
TEST(OtherSensors, FlyingPixelsAroundABallAreNoCone) {
  for (const BallBeforeWall& scene :
       {BallBeforeWall{0.09, 1.3, 0.06, 3}, BallBeforeWall{0.09, 1.0, 0.1, 5}, BallBeforeWall{0.12, 1.0, 0.06, 5}}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      int balls = 0, others = 0;
      for (const Detection& item : foundIn(scene.seen(seed)).items) {
        const Kind kind = kindOf(item.shape);
        balls += kind == Kind::sphere ? 1 : 0;
        others += kind == Kind::cone || kind == Kind::cylinder ? 1 : 0;
      }
      EXPECT_EQ(balls, 1) << scene.radius << " m, seed " << seed;
      EXPECT_EQ(others, 0) << scene.radius << " m, seed " << seed;
    }
  }
}

/// A wall that is seen at less than 6 deg between two that face the camera, so many pixels wide across its slope.
class SteepWall {
 public:
  /// turn: of the slope in the image, rad
  SteepWall(double pixels, double turn) : right_(std::cos(turn)), down_(std::sin(turn)) {
    std::vector<float> depth(camera_.pixelCount());
    for (std::size_t i = 0; i < depth.size(); ++i) {
      const double column = static_cast<double>(i % 640) - kColumn, row = static_cast<double>(i / 640) - kRow;
      depth[i] = static_cast<float>(depthAt(std::clamp(column * right_ + row * down_, -0.5 * pixels, 0.5 * pixels)));
    }
    cloudFromDepth(depth, camera_, DepthRange(), cloud_);
  }

  void lose(int column, int row) {
    const std::size_t i = static_cast<std::size_t>(kRow + row) * 640 + static_cast<std::size_t>(kColumn + column);
    cloud_.x[i] = cloud_.y[i] = cloud_.z[i] = std::nanf("");
  }

  bool flies(double noise_scale = 1.0) const {
    const ImageRays rays = findRays(cloud_);
    EXPECT_TRUE(rays.known);
    constexpr std::uint32_t kPixel = kRow * 640 + kColumn;
    const Vec3 point = cloud_.point(kPixel);
    // Across the slope it is level; along it another place of it.
    const Vec3 level(-down_, right_, 0.0);
    const Vec3 along = Vec3(right_, down_, 0.0) * (0.5 / camera_.fx) + Vec3::UnitZ() * (depthAt(0.5) - 1.0);
    const Vec3 normal = level.cross(along).normalized();
    return fliesBetween({cloud_, rays, noise_scale, 1.0}, kPixel, point, normal);
  }

 private:
  static constexpr int kColumn = 320, kRow = 240;

  /// So many pixels along the slope; 1 m in the middle.
  static double depthAt(double pixels) { return 1.0 + 0.02 * pixels; }

  synthetic::PinholeCamera camera_;
  Cloud cloud_;
  double right_, down_;
};

TEST(OtherSensors, OnlyNarrowSlopesAreFlyingPixels) {
  for (const double turn : {0.0, 45.0, 90.0, 120.0, 200.0}) {
    EXPECT_TRUE(SteepWall(3.0, turn * test::kDegree).flies()) << turn;
    EXPECT_FALSE(SteepWall(30.0, turn * test::kDegree).flies()) << turn;
    EXPECT_FALSE(SteepWall(30.0, turn * test::kDegree).flies(3.0)) << turn;
  }
}

TEST(OtherSensors, WhatIsMissingMakesNoFlyingPixels) {
  SteepWall wall(30.0, 0.0);
  for (const int column : {-3, -1, 1, 2}) wall.lose(column, 0);
  EXPECT_FALSE(wall.flies());
  SteepWall alone(3.0, 0.0);
  for (int column = 1; column < 12; ++column) alone.lose(column, 0);
  EXPECT_FALSE(alone.flies()) << "nothing was measured behind";
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
  EXPECT_EQ(found, 12) << "9 where every blot speaks against a can";
}

/// Noise that 7 x 7 pixels share turns normals there by 15 deg and more (test_image_noise).
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
}  // namespace primitect::other_sensors_test
