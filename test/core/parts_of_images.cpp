// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth images of which one object is left, and coarse ones.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "primitect/detector.h"
#include "test/support/ball_and_wall.h"

namespace primitect::parts_of_images_test {
namespace {

using test::BallAndWall;

/// What is nearer than the wall, as an image or as a list of points.
Cloud ballAlone(const BallAndWall& scene, std::uint64_t seed, bool organized) {
  const Cloud image = scene.image(seed);
  Cloud alone;
  organized ? alone.reset(image.width, image.height, false)
            : alone.reset(static_cast<std::uint32_t>(scene.onBall(image)), 1, false);
  std::size_t next = 0;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (image.z[i] < scene.wall - 0.1) {
      alone.setPoint(organized ? i : next++, image.x[i], image.y[i], image.z[i], {});
    }
  }
  return alone;
}

void expectOnlyBall(const Sphere& ball, const Detections& found) {
  ASSERT_EQ(found.items.size(), 1u);
  const Sphere* sphere = std::get_if<Sphere>(&found.items[0].shape);
  ASSERT_TRUE(sphere);
  EXPECT_LT((sphere->center - ball.center).norm(), 0.003);
  EXPECT_NEAR(sphere->radius, ball.radius, 0.003);
}

TEST(PartOfAnImage, IsLookedAtInTheScaleOfItsDepth) {
  // The largest radius is 0.3 d_s, and half a ball has a diagonal of three radii.
  for (const double radius : {0.04, 0.1, 0.2}) {
    for (const bool organized : {true, false}) {
      BallAndWall scene;
      scene.every = 1;
      scene.ball.radius = radius;
      Detector detector{Params()};
      const Detections& found = detector.detect(ballAlone(scene, 11, organized));
      SCOPED_TRACE(radius);
      expectOnlyBall(scene.ball, found);
      EXPECT_NEAR(found.scene_diameter, scene.ball.center.z(), 0.25);
    }
  }
}

TEST(PartOfAnImage, HasNoMoreSamplesThanItsWindowsTellApart) {
  const BallAndWall scene{1, 1.2, {Vec3(0.05, 0.02, 1.0), 0.04}};
  const Cloud alone = ballAlone(scene, 12, true);
  Detector detector{Params()};
  const Detections& found = detector.detect(alone);
  expectOnlyBall(scene.ball, found);
  EXPECT_GT(alone.valid_count, 1500u);
  EXPECT_LT(found.samples, alone.valid_count / 10);
  ASSERT_FALSE(found.items.empty());
  EXPECT_GT(found.items[0].inlier_count, 0.9 * alone.valid_count) << "the measures are taken from all";
}

TEST(PartOfAnImage, HasMoreSamplesWhereEachBringsItsOwnNormal) {
  const BallAndWall scene{1, 1.2, {Vec3(0.05, 0.02, 1.0), 0.04}};
  Cloud alone = ballAlone(scene, 12, true);
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (std::vector<float>* normals : {&alone.nx, &alone.ny, &alone.nz}) normals->assign(alone.size(), none);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (!alone.valid(i)) continue;
    const Vec3 away = scene.normalAt({alone.x[i], alone.y[i], alone.z[i]});
    alone.nx[i] = static_cast<float>(away.x()), alone.ny[i] = static_cast<float>(away.y());
    alone.nz[i] = static_cast<float>(away.z());
  }
  Detector detector{Params()};
  const Detections& found = detector.detect(alone);
  expectOnlyBall(scene.ball, found);
  EXPECT_GT(found.samples, alone.valid_count / 2);
}

TEST(PartOfAnImage, KeepsTheScaleThatItIsGiven) {
  Params params;
  params.scene_diameter = 0.6;
  Detector detector(params);
  EXPECT_EQ(detector.detect(ballAlone(BallAndWall(), 13, true)).scene_diameter, 0.6);
}

TEST(ListOfPoints, MayComeInOneColumnOrTwoRows) {
  BallAndWall scene;
  scene.ball.radius = 0.15;
  const Cloud image = scene.image(42);
  for (const std::uint32_t rows : {1u, 2u, static_cast<std::uint32_t>(image.size())}) {
    Cloud list = image;
    list.width = static_cast<std::uint32_t>(image.size()) / rows, list.height = rows;
    Detector detector{Params()};
    int balls = 0;
    for (const Detection& item : detector.detect(list).items) balls += kindOf(item.shape) == Kind::sphere ? 1 : 0;
    EXPECT_EQ(balls, 1) << rows << " rows";
  }
}

TEST(PartOfAnImage, IsNotPulledTowardsTheCameraWhereDepthCutsIt) {
  // Of the surface just beyond the cut only the points are left that noise moved before it.
  const BallAndWall scene{1, 2.6, {Vec3(0.05, 0.02, 2.0), 0.15}};
  Params params;
  params.max_depth = 1.9;
  constexpr int kImages = 8;
  double error = 0.0;
  for (std::uint64_t seed = 1; seed <= kImages; ++seed) {
    Random random(seed);
    Cloud cut = scene.image(seed);
    for (std::size_t i = 0; i < cut.size(); ++i) {
      const auto times = static_cast<float>(1.0 + 0.0055 * random.gaussian() / cut.z[i]);
      cut.x[i] *= times, cut.y[i] *= times, cut.z[i] *= times;
      if (cut.z[i] > params.max_depth) cut.x[i] = cut.y[i] = cut.z[i] = std::numeric_limits<float>::quiet_NaN();
    }
    cut.countPoints();
    Detector detector(params);
    const Detections& found = detector.detect(cut);
    ASSERT_EQ(found.items.size(), 1u) << seed;
    const Sphere* sphere = std::get_if<Sphere>(&found.items[0].shape);
    ASSERT_TRUE(sphere) << seed;
    error += (sphere->radius - scene.ball.radius) / kImages;
  }
  EXPECT_LT(std::abs(error), 0.0035) << "was 0.007";
}

TEST(ImageOfFarThings, HasTheNoiseThatIsMeasured) {
  // What a depth camera's noise grows to at 24 m, 1 m, would make one plane of ball and wall.
  constexpr float kTimes = 20.0f;
  BallAndWall scene;
  Cloud image = scene.image(41);
  for (std::vector<float>* values : {&image.x, &image.y, &image.z}) {
    for (float& value : *values) value *= kTimes;
  }
  Detector detector{Params()};
  int balls = 0;
  for (const Detection& item : detector.detect(image).items) {
    const Sphere* sphere = std::get_if<Sphere>(&item.shape);
    balls += sphere && std::abs(sphere->radius - kTimes * scene.ball.radius) < 0.1 ? 1 : 0;
  }
  EXPECT_EQ(balls, 1);
}

TEST(CoarseImage, ShowsWhatAFineOneShows) {
  // 160 x 120 pixels: the ball is 17 wide. Nothing but its limb would be left to a window of 15, as in a fine image.
  BallAndWall scene;
  scene.every = 4;
  scene.ball.radius = 0.06;
  for (std::uint64_t seed = 21; seed < 26; ++seed) {
    Detector detector{Params()};
    const Detections& found = detector.detect(scene.image(seed));
    int balls = 0, walls = 0;
    for (const Detection& item : found.items) {
      const Sphere* sphere = std::get_if<Sphere>(&item.shape);
      balls += sphere && std::abs(sphere->radius - scene.ball.radius) < 0.005 ? 1 : 0;
      walls += kindOf(item.shape) == Kind::plane ? 1 : 0;
    }
    EXPECT_EQ(balls, 1) << seed;
    EXPECT_EQ(walls, 1) << seed;
    EXPECT_EQ(found.items.size(), 2u) << seed;
  }
}

}  // namespace
}  // namespace primitect::parts_of_images_test
