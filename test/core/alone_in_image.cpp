// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A ball or a tube alone in the image, so close that d_s is hardly more than twice its radius.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "primitect/detector.h"
#include "test/support/rendered_cloud.h"

namespace primitect::alone_in_image_test {
namespace {

/// A body alone in the image, its middle `depth` (m) away from the camera and its long axis up.
template <class Shape>
Cloud imageOf(const Shape& shape, double depth, double noise_scale, std::uint64_t seed) {
  synthetic::World world;
  world.add("thing", shape,
            Eigen::Translation3d(0.0, 0.0, depth) * Eigen::Isometry3d(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitX())));
  synthetic::FrameParams params;
  params.noise.scale = noise_scale;
  if (noise_scale == 0.0) params.noise.disparity_step = 0.0;
  params.noise.max_incidence_deg = 90.0;
  return test::renderedCloud(world, params, seed);
}

/// Radii beyond all bins had no votes, and more than twenty planes took what a ball of 20 cm at 60 cm shows.
TEST(AloneInImage, ALargeBallIsABall) {
  std::uint64_t seed = 0;
  for (const double share_of_depth : {0.2, 0.28, 0.33, 0.38}) {
    for (const double depth : {0.9, 1.2, 1.5}) {
      for (const double noise_scale : {0.0, 1.0}) {
        const double radius = share_of_depth * depth;
        Detector detector{Params()};
        const auto result = detector.detect(imageOf(synthetic::Ball{radius}, depth, noise_scale, ++seed));
        ASSERT_EQ(result.items.size(), 1u) << radius << " at " << depth << ", noise " << noise_scale;
        const Sphere* const found = std::get_if<Sphere>(&result.items[0].shape);
        ASSERT_TRUE(found) << radius << " at " << depth << ", noise " << noise_scale;
        EXPECT_NEAR(found->radius, radius, 0.01 * radius);
        EXPECT_NEAR(found->center.z(), depth, 0.01 * radius);
      }
    }
  }
}

/// Pairs within reach of a candidate turned too little to be anything but planes: strips of the tube they were.
TEST(AloneInImage, AWideTubeIsATube) {
  std::uint64_t seed = 100;
  for (const double share_of_depth : {0.15, 0.2, 0.25, 0.28}) {
    for (const double depth : {0.9, 1.2}) {
      for (const double noise_scale : {0.0, 1.0}) {
        const double radius = share_of_depth * depth;
        Detector detector{Params()};
        const auto result = detector.detect(imageOf(synthetic::Rod{radius, 1.5 * radius}, depth, noise_scale, ++seed));
        ASSERT_GE(result.items.size(), 1u) << radius << " at " << depth << ", noise " << noise_scale;
        const Cylinder* const found = std::get_if<Cylinder>(&result.items[0].shape);
        ASSERT_TRUE(found) << radius << " at " << depth << ", noise " << noise_scale;
        EXPECT_NEAR(found->radius, radius, 0.01 * radius);
      }
    }
  }
}

/// Pairs near each other turn too little, or the bins of radii end before: they are found in facets.
TEST(AloneInImage, WhatIsFarLargerThanTheImageIsFoundInFacets) {
  std::uint64_t seed = 200;
  for (const double radius : {0.5, 0.7, 1.0}) {
    for (const double nearest : {0.5, 0.75, 1.0}) {
      SCOPED_TRACE(testing::Message() << radius << " at " << nearest);
      const double depth = nearest + radius;
      const auto ball = Detector{Params()}.detect(imageOf(synthetic::Ball{radius}, depth, 1.0, ++seed));
      ASSERT_EQ(ball.items.size(), 1u);
      ASSERT_EQ(kindOf(ball.items[0].shape), Kind::sphere);
      EXPECT_NEAR(std::get<Sphere>(ball.items[0].shape).radius, radius, 0.01 * radius);
      const auto drum = Detector{Params()}.detect(imageOf(synthetic::Rod{radius, 1.5 * radius}, depth, 1.0, ++seed));
      ASSERT_EQ(drum.items.size(), 1u);
      ASSERT_EQ(kindOf(drum.items[0].shape), Kind::cylinder);
      EXPECT_NEAR(std::get<Cylinder>(drum.items[0].shape).radius, radius, 0.01 * radius);
    }
  }
}

TEST(AloneInImage, WithoutFacetsSuchAreSeveralPlanes) {
  Params without;
  without.left_out.add(Step::facets);
  const auto result = Detector{without}.detect(imageOf(synthetic::Ball{1.0}, 1.75, 1.0, 213));
  EXPECT_GT(result.items.size(), 1u);
  for (const Detection& item : result.items) EXPECT_EQ(kindOf(item.shape), Kind::plane);
}

/// Lengths then do not depend on what is in view.
TEST(AloneInImage, RadiiReachAsFarAsAGivenSceneDiameterSays) {
  constexpr double kRadius = 0.25;
  for (const double reach : {0.2, 0.3}) {
    Params params;
    params.scene_diameter = reach / (params.radius_bin * params.radius_bins);
    Detector detector{params};
    const auto result = detector.detect(imageOf(synthetic::Ball{kRadius}, 0.9, 1.0, 300));
    int balls = 0;
    for (const Detection& item : result.items) balls += kindOf(item.shape) == Kind::sphere ? 1 : 0;
    EXPECT_EQ(balls, reach > kRadius ? 1 : 0) << reach;
  }
}

}  // namespace
}  // namespace primitect::alone_in_image_test
