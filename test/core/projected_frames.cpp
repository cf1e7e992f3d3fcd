// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whole frames of a depth camera that lost their order: what is found, counted and labelled in them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "core/image_rays.h"
#include "core/projected_image.h"
#include "primitect/detector.h"
#include "test/support/ball_and_wall.h"

namespace primitect::projected_frames_test {
namespace {

const test::BallAndWall kScene;

std::vector<Eigen::Vector3f> pointsOf(const Cloud& cloud) {
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < cloud.size(); ++i) points.emplace_back(cloud.x[i], cloud.y[i], cloud.z[i]);
  return points;
}

/// In random order.
Cloud unorganized(std::vector<Eigen::Vector3f> points) {
  Random random(7);
  for (std::size_t i = points.size() - 1; i > 0; --i) std::swap(points[i], points[random.below(i + 1)]);
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(points.size()), 1, false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.setPoint(i, points[i].x(), points[i].y(), points[i].z(), {});
  }
  return cloud;
}

/// Of the ball; -1 unless a wall and a ball were found where they are, and nothing else.
int indexOfBall(const Detections& found) {
  if (found.items.size() != 2) return -1;
  const int ball = kindOf(found.items[0].shape) == Kind::sphere ? 0 : 1;
  const Sphere* sphere = std::get_if<Sphere>(&found.items[ball].shape);
  const Plane* plane = std::get_if<Plane>(&found.items[1 - ball].shape);
  if (!sphere || !plane) return -1;
  EXPECT_LT((sphere->center - kScene.ball.center).norm(), 0.002);
  EXPECT_NEAR(sphere->radius, kScene.ball.radius, 0.002);
  EXPECT_NEAR(distance(*plane, Vec3(0.0, 0.0, kScene.wall)), 0.0, 0.001);
  return ball;
}

void expectCountsAreThoseOfLabels(const Detector& detector, const Cloud& cloud) {
  std::vector<std::uint32_t> labels;
  detector.label(cloud, labels);
  ASSERT_EQ(labels.size(), cloud.size());
  const Detections& found = detector.result();
  for (std::uint32_t k = 0; k < found.items.size(); ++k) {
    const auto labelled = static_cast<double>(std::count(labels.begin(), labels.end(), k + 1));
    // A label is of the point itself, the count is of the one that its pixel holds.
    EXPECT_NEAR(found.items[k].inlier_count, labelled, 0.03 * labelled) << k;
  }
}

TEST(ProjectedFrame, IsWorkedOnLikeTheImageThatItWas) {
  const Cloud image = kScene.image(1), cloud = unorganized(pointsOf(image));
  Detector detector{Params()};
  const int ball = indexOfBall(detector.detect(cloud));
  ASSERT_GE(ball, 0);
  const Detections& found = detector.result();
  EXPECT_EQ(found.points_in, cloud.size());
  EXPECT_EQ(found.points_used, cloud.size());
  EXPECT_NEAR(found.items[ball].inlier_count, kScene.onBall(image), 0.05 * kScene.onBall(image));
  EXPECT_EQ(found.items[ball].truncated, 0);
  EXPECT_TRUE(found.items[1 - ball].truncated & kTruncationUnknown) << "a list does not tell where the image ended";
  expectCountsAreThoseOfLabels(detector, cloud);
}

TEST(ProjectedFrame, HasThePixelsOfTheCameraWhereItsPointsLieOnItsRays) {
  const Cloud image = kScene.image(1), cloud = unorganized(pointsOf(image));
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(cloud));
  EXPECT_TRUE(projected.isExact());
  EXPECT_EQ(projected.image().valid_count, cloud.valid_count) << "each has a pixel of its own";
  const ImageRays rays = findRays(projected.image()), of_camera = findRays(image);
  ASSERT_TRUE(rays.known);
  EXPECT_LT(rays.misfit, 0.01);
  EXPECT_NEAR(rays.x_scale, of_camera.x_scale, 1e-4 * of_camera.x_scale);
  EXPECT_NEAR(rays.y_scale, of_camera.y_scale, 1e-4 * of_camera.y_scale);
}

TEST(ProjectedFrame, HasPixelsOfItsOwnWhereThePointsLieBesideTheRays) {
  Random random(2);
  const double beside = 0.3 * findRays(kScene.image(1)).x_scale;  // a third of a pixel
  std::vector<Eigen::Vector3f> points = pointsOf(kScene.image(1));
  for (Eigen::Vector3f& point : points) {
    const double aside = beside * point.z();
    const Eigen::Vector3f moved = {static_cast<float>(aside * random.gaussian()),
                                   static_cast<float>(aside * random.gaussian()), 0.0f};
    point += moved;
  }
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(unorganized(points)));
  EXPECT_FALSE(projected.isExact());
}

/// On the lattice: pixels hold two points each, or most hold none.
TEST(ProjectedFrame, HasThePixelsOfTheCameraForTwoOfItsFramesButNotForFewPoints) {
  std::vector<Eigen::Vector3f> both = pointsOf(kScene.image(1)), few;
  Random random(4);
  std::copy_if(both.begin(), both.end(), std::back_inserter(few), [&](const auto&) { return random.uniform() < 0.25; });
  for (const Eigen::Vector3f& point : pointsOf(kScene.image(2))) both.push_back(point);
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(unorganized(both)));
  EXPECT_TRUE(projected.isExact());
  EXPECT_EQ(projected.image().valid_count, both.size() / 2);
  ASSERT_TRUE(projected.make(unorganized(few)));
  EXPECT_FALSE(projected.isExact());
}

TEST(ProjectedFrame, CountsNoMissingPoint) {
  // All missing points lie at the end, three times as many as others: none may count for what any pixel holds.
  const Cloud image = kScene.image(2);
  Cloud cloud = unorganized(pointsOf(image));
  const std::size_t measured = cloud.size();
  for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) {
    values->resize(4 * measured, std::numeric_limits<float>::quiet_NaN());
  }
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  Detector detector{Params()};
  const int ball = indexOfBall(detector.detect(cloud));
  ASSERT_GE(ball, 0);
  const Detections& found = detector.result();
  EXPECT_EQ(found.points_used, measured);
  EXPECT_LE(found.items[0].inlier_count + found.items[1].inlier_count, measured);
  expectCountsAreThoseOfLabels(detector, cloud);
}

TEST(ProjectedFrame, MayHoldSeveralFramesOfOneCamera) {
  std::vector<Eigen::Vector3f> points;
  for (std::uint64_t seed = 3; seed < 6; ++seed) {
    for (const Eigen::Vector3f& point : pointsOf(kScene.image(seed))) points.push_back(point);
  }
  const Cloud cloud = unorganized(points);
  Detector detector{Params()};
  const int ball = indexOfBall(detector.detect(cloud));
  ASSERT_GE(ball, 0);
  const double seen = 3.0 * kScene.onBall(kScene.image(3));
  EXPECT_NEAR(detector.result().items[ball].inlier_count, seen, 0.06 * seen);
  EXPECT_TRUE(ProjectedImage().make(cloud));
  expectCountsAreThoseOfLabels(detector, cloud);
}

TEST(ProjectedFrame, IsMadeWhereNormalFieldsHoldNothing) {
  Cloud cloud = unorganized(pointsOf(kScene.image(12))), same = cloud;
  for (std::vector<float>* values : {&cloud.nx, &cloud.ny, &cloud.nz}) {
    values->assign(cloud.size(), std::numeric_limits<float>::quiet_NaN());
  }
  Detector with_fields{Params()}, without{Params()};
  const int ball = indexOfBall(with_fields.detect(cloud));
  ASSERT_GE(ball, 0);
  EXPECT_EQ(without.detect(same).items[ball].covariance, with_fields.result().items[ball].covariance);
}

TEST(ProjectedFrame, LeavesAFewPointsFarAsideOut) {
  const Cloud image = kScene.image(6);
  std::vector<Eigen::Vector3f> points = pointsOf(image);
  const std::size_t seen = points.size();
  Random random(8);
  for (int k = 0; k < 40; ++k) {
    const double side = k % 2 == 0 ? 1.6 : -1.6;
    points.emplace_back(Eigen::Vector3f(side, random.uniform(-1.6, 1.6), 1.0));
  }
  const Cloud cloud = unorganized(points);
  Detector detector{Params()};
  const int ball = indexOfBall(detector.detect(cloud));
  ASSERT_GE(ball, 0);
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(cloud));
  EXPECT_LT(projected.image().size(), 4 * seen);
  EXPECT_NEAR(detector.result().items[ball].inlier_count, kScene.onBall(image), 0.05 * kScene.onBall(image));
}

TEST(ProjectedFrame, LeavesOutWhatNoCameraSees) {
  const Cloud image = kScene.image(13);
  std::vector<Eigen::Vector3f> points = pointsOf(image);
  points.emplace_back(0.1f, 0.0f, -1.0f);  // behind the sensor
  points.emplace_back(2.1f, 0.0f, 1.0f);   // beside it
  const Cloud cloud = unorganized(points);
  Detector detector{Params()};
  const int ball = indexOfBall(detector.detect(cloud));
  ASSERT_GE(ball, 0);
  ProjectedImage projected;
  ASSERT_TRUE(projected.make(cloud));
  EXPECT_EQ(std::count(projected.pixel().begin(), projected.pixel().end(), ProjectedImage::kNoPixel), 2);
  EXPECT_NEAR(detector.result().items[ball].inlier_count, kScene.onBall(image), 0.05 * kScene.onBall(image));
  // Seen from a place among its points a cloud is none of a camera's.
  for (std::size_t k = 0; k < points.size() / 100; ++k) points.emplace_back(0.1f, 0.0f, -1.0f);
  EXPECT_FALSE(projected.make(unorganized(points)));
}

TEST(ProjectedFrame, IsNoneOfRowsFarApart) {
  // As of a laser scanner: an image with empty rows between would leave its windows nothing to fit.
  test::BallAndWall scene;
  scene.every = 1;
  scene.ball.radius = 0.2;
  Cloud image = scene.image(19);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (i / image.width % 8 == 0) {
      points.emplace_back(image.x[i], image.y[i], image.z[i]);
    } else {
      image.x[i] = image.y[i] = image.z[i] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  image.countPoints();
  for (const Cloud& cloud : {image, unorganized(points)}) {
    EXPECT_FALSE(ProjectedImage().make(cloud));
    Detector detector{Params()};
    const Detections& found = detector.detect(cloud);
    ASSERT_EQ(found.items.size(), 2u) << cloud.height;
    int balls = 0;
    for (const Detection& item : found.items) {
      const Sphere* sphere = std::get_if<Sphere>(&item.shape);
      balls += sphere && std::abs(sphere->radius - scene.ball.radius) < 0.005 ? 1 : 0;
    }
    EXPECT_EQ(balls, 1) << cloud.height;
    expectCountsAreThoseOfLabels(detector, cloud);
  }
}

TEST(ProjectedFrame, OfOtherUnitsHasNotTheNoiseOfACamera) {
  // In millimetres a camera's noise, which grows with the square of the depth, would allow everything.
  std::vector<Eigen::Vector3f> points = pointsOf(kScene.image(20));
  for (Eigen::Vector3f& point : points) point *= 1000.0f;
  Detector detector{Params()};
  int balls = 0;
  for (const Detection& item : detector.detect(unorganized(points)).items) {
    const Sphere* sphere = std::get_if<Sphere>(&item.shape);
    balls += sphere && std::abs(sphere->radius - 1000.0 * kScene.ball.radius) < 5.0 ? 1 : 0;
  }
  EXPECT_EQ(balls, 1);
}

TEST(ProjectedFrame, IsACoarserOneWhereFewPixelsAreMeasured) {
  test::BallAndWall scene;
  scene.every = 1;
  for (const double kept : {0.25, 0.1}) {
    Cloud image = scene.image(10);
    Random random(11);
    for (std::size_t i = 0; i < image.size(); ++i) {
      if (random.uniform() > kept) image.x[i] = image.y[i] = image.z[i] = std::numeric_limits<float>::quiet_NaN();
    }
    image.countPoints();
    Detector detector{Params()};
    const int ball = indexOfBall(detector.detect(image));
    ASSERT_GE(ball, 0) << kept;
    EXPECT_NEAR(detector.result().items[ball].inlier_count, scene.onBall(image), 0.06 * scene.onBall(image));
    expectCountsAreThoseOfLabels(detector, image);
  }
}

TEST(ProjectedFrame, LeavesNoTraceInLaterFrames) {
  const Cloud image = kScene.image(9), cloud = unorganized(pointsOf(image));
  Detector used{Params()}, of_image{Params()}, of_cloud{Params()};
  used.detect(cloud);
  used.detect(Cloud());
  const auto expectSame = [&used](const Cloud& frame, Detector& fresh) {
    const Detections &a = used.detect(frame), &b = fresh.detect(frame);
    ASSERT_EQ(a.items.size(), b.items.size());
    EXPECT_FALSE(a.items.empty());
    for (std::size_t k = 0; k < a.items.size(); ++k) {
      EXPECT_EQ(a.items[k].inlier_count, b.items[k].inlier_count);
      EXPECT_EQ(a.items[k].covariance, b.items[k].covariance);
      EXPECT_EQ(a.items[k].truncated, b.items[k].truncated);
    }
    EXPECT_EQ(a.refusals.counts, b.refusals.counts);
  };
  expectSame(image, of_image);
  expectSame(cloud, of_cloud);
}

}  // namespace
}  // namespace primitect::projected_frames_test
