// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes among the points of another one, and what only lies beside or on it.
#include "core/interleaved.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "core/extent.h"
#include "primitect/detector.h"
#include "synthetic/clutter.h"
#include "synthetic/sensors.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::interleaved_test {
namespace {

using test::kDegree;

const NoiseModel kNoiseModel = {0.0, 0.002};  // 2 mm at 1 m

/// A wall 1 m before the camera, a point each centimetre.
class Wall {
 public:
  Wall() {
    cloud_.reset(121, 81, false);
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      const auto column = static_cast<float>(i % 121), row = static_cast<float>(i / 121);
      cloud_.setPoint(i, 0.01f * (column - 60.0f), 0.01f * (row - 40.0f), 1.0f, {});
      pixels_.push_back(static_cast<std::uint32_t>(i));
    }
    wall_.shape = Plane{Vec3(0, 0, 1), -Vec3::UnitZ()};
    wall_.inlier_count = static_cast<std::uint32_t>(cloud_.size());
  }

  /// Of those left of x (m) only.
  void keepLeftOf(float x) {
    List<std::uint32_t> left;
    for (const std::uint32_t i : pixels_) {
      if (cloud_.x[i] < x) left.push_back(i);
    }
    wall_.inlier_count = static_cast<std::uint32_t>(left.size());
    pixels_ = left;
  }

  bool holds(const Detection& plane) const { return isAmong(plane, wall_, pixels_, cloud_, kNoiseModel); }

  Detection wall_;

 private:
  Cloud cloud_;
  List<std::uint32_t> pixels_;
};

/// 40 by 20 cm in the middle of the wall, so far before it and tilted; with as many points as the wall has there.
Detection patch(double height, double tilt, double left = -0.2) {
  Detection detection;
  const Vec3 middle(left + 0.2, 0.0, 1.0 - height), along(std::cos(tilt), 0.0, std::sin(tilt));
  const Plane plane = {middle, Vec3(std::sin(tilt), 0.0, -std::cos(tilt))};
  std::vector<Vec3> corners;
  for (const double x : {-0.2, 0.2}) {
    for (const double y : {-0.1, 0.1}) corners.push_back(middle + x * along + y * Vec3::UnitY());
  }
  detection.shape = plane;
  detection.extent = measureExtent(plane, corners);
  detection.inlier_count = 800;
  return detection;
}

TEST(PlaneAmongPoints, IsAcrossAnotherOneWithinTheNoise) {
  const Wall wall;
  EXPECT_TRUE(wall.holds(patch(0.0, 0.5 * kDegree)));
  EXPECT_TRUE(wall.holds(patch(0.003, 0.0)));
  EXPECT_TRUE(wall.holds(patch(0.0, 1.5 * kDegree)));
}

TEST(PlaneAmongPoints, IsNotBesideIt) {
  Wall wall;
  EXPECT_FALSE(wall.holds(patch(0.0, 1.5 * kDegree, 0.5))) << "mostly beyond its border";
  wall.keepLeftOf(-0.2f);
  EXPECT_FALSE(wall.holds(patch(0.0, 1.5 * kDegree))) << "none of its points there";
}

TEST(PlaneAmongPoints, IsNoBookOnATable) {
  EXPECT_FALSE(Wall().holds(patch(0.01, 0.0)));  // five standard deviations
}

TEST(PlaneAmongPoints, IsNoRampThatLeavesIt) {
  const Wall wall;
  EXPECT_FALSE(wall.holds(patch(0.0, 4.0 * kDegree))) << "near it in less than half of its outline";
  EXPECT_FALSE(wall.holds(patch(0.0, 8.0 * kDegree)));
}

TEST(PlaneAmongPoints, IsTheSmallerOne) {
  Wall wall;
  Detection large = patch(0.0, 0.5 * kDegree);
  large.inlier_count = wall.wall_.inlier_count + 1;
  EXPECT_FALSE(wall.holds(large));
}

TEST(PlaneAmongPoints, AsksForTwoPlanes) {
  Wall wall;
  Detection ball = patch(0.0, 0.0);
  ball.shape = Sphere{Vec3(0, 0, 1.1), 0.1};
  EXPECT_FALSE(wall.holds(ball));
  wall.wall_.shape = Sphere{Vec3(0, 0, 101), 100.0};
  EXPECT_FALSE(wall.holds(patch(0.0, 0.5 * kDegree)));
}

/// Planes within 10 mm of a larger one and nearly parallel to it, that begin within its outline.
int foundTwice(const Detections& found) {
  int count = 0;
  for (const Detection& small : found.items) {
    for (const Detection& large : found.items) {
      const Plane *const own = std::get_if<Plane>(&small.shape), *const other = std::get_if<Plane>(&large.shape);
      if (!own || !other || small.inlier_count >= large.inlier_count) continue;
      const Vec3 way = large.extent.rotation.transpose() * (small.extent.origin - large.extent.origin);
      const bool within = (way.head<2>().cwiseAbs().array() < 0.5 * large.extent.size.head<2>().array()).all();
      count += within && std::abs(way.z()) < 0.01 && own->normal.dot(other->normal) > std::cos(3.0 * kDegree) ? 1 : 0;
    }
  }
  return count;
}

/// Whose noise comes in waves of centimetres: a second plane was found across each of these.
TEST(Table, SeenByAStereoCameraIsFoundOnce) {
  synthetic::FrameParams params;
  params.noise = synthetic::noiseOf("stereo");
  Detector detector{Params()};
  for (const std::uint64_t seed : {5001, 5011}) {
    const Cloud cloud =
        test::renderedCloud(synthetic::clutteredTable(seed), params, seed, synthetic::clutterPose(seed));
    const Detections& found = detector.detect(cloud);
    EXPECT_GT(found.items.size(), 3u);
    EXPECT_EQ(foundTwice(found), 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace primitect::interleaved_test
