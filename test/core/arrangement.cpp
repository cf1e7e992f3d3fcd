// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which clouds are worked on as images: those that a camera at the origin saw.
#include "core/arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/random.h"
#include "primitect/detector.h"
#include "synthetic/poses.h"
#include "test/support/ball_and_wall.h"

namespace primitect::arrangement_test {
namespace {

using synthetic::robotFromCamera;

const test::BallAndWall kScene;

/// All points are above the origin, and hide each other when looked at from there.
Cloud inFrameOfRobot(Cloud cloud) {
  cloud.move(robotFromCamera(2.0, 0.7), DepthRange());
  EXPECT_EQ(cloud.behind_count, 0u);
  return cloud;
}

Cloud shuffledList(Cloud cloud) {
  Random random(5);
  for (std::size_t i = cloud.size() - 1; i > 0; --i) {
    const std::size_t k = random.below(i + 1);
    for (auto* values : {&cloud.x, &cloud.y, &cloud.z}) std::swap((*values)[i], (*values)[k]);
  }
  cloud.width *= cloud.height, cloud.height = 1;
  return cloud;
}

/// Column and row changed places, as in an image turned by a quarter and mirrored.
Cloud transposed(const Cloud& image) {
  Cloud result;
  result.reset(image.height, image.width, false);
  for (std::uint32_t row = 0; row < image.height; ++row) {
    for (std::uint32_t column = 0; column < image.width; ++column) {
      const std::size_t from = row * image.width + column;
      result.setPoint(column * image.height + row, image.x[from], image.y[from], image.z[from], {});
    }
  }
  return result;
}

/// As through a wide lens without correction: the pixel at the corner sees a fifth less far aside.
Cloud distorted(const Cloud& image) {
  Cloud result = image;
  for (std::size_t i = 0; i < image.size(); ++i) {
    const double u = image.x[i] / image.z[i], v = image.y[i] / image.z[i];
    const float factor = static_cast<float>(1.0 - 0.4 * (u * u + v * v));
    result.x[i] *= factor, result.y[i] *= factor;
  }
  return result;
}

TEST(Arrangement, KeepsImagesOfCamerasAlsoTransposedAndThroughPoorLenses) {
  const Cloud image = kScene.image(1);
  for (const Cloud& cloud : {image, transposed(image), distorted(image)}) {
    Arrangement arrangement;
    EXPECT_EQ(&arrangement.of(cloud, false), &cloud);
    EXPECT_TRUE(arrangement.seenFromOrigin());
    EXPECT_EQ(arrangement.projected(), nullptr);
    EXPECT_TRUE(mayBeOfDepthCamera(cloud));
  }
}

TEST(Arrangement, TakesAnImageInAnotherFrameAsAList) {
  const Cloud cloud = inFrameOfRobot(kScene.image(2));
  ASSERT_TRUE(mayBeOfDepthCamera(cloud)) << "nothing else tells";
  for (const bool brings_normals : {false, true}) {
    Arrangement arrangement;
    const Cloud& seen = arrangement.of(cloud, brings_normals);
    EXPECT_FALSE(seen.organized());
    EXPECT_EQ(seen.size(), cloud.size());
    EXPECT_FALSE(arrangement.seenFromOrigin());
    EXPECT_FALSE(mayBeOfDepthCamera(seen));
  }
}

TEST(Arrangement, MakesNoImageOfOneInAnotherFrameThatHidesNothingThere) {
  // The camera looks down: seen from below a floor is a floor.
  test::BallAndWall scene;
  scene.ball.center.z() = 2.0 * scene.wall;
  Cloud cloud = scene.image(7);
  cloud.move(robotFromCamera(2.5, 1.5), DepthRange());
  Arrangement arrangement;
  EXPECT_FALSE(arrangement.of(cloud, false).organized());
  EXPECT_FALSE(arrangement.seenFromOrigin());
  EXPECT_TRUE(arrangement.of(shuffledList(cloud), false).organized());
  EXPECT_TRUE(arrangement.seenFromOrigin());
}

TEST(Arrangement, MakesNoImageOfAListInAnotherFrame) {
  const Cloud cloud = shuffledList(inFrameOfRobot(kScene.image(3)));
  Arrangement arrangement;
  EXPECT_EQ(&arrangement.of(cloud, false), &cloud);
  EXPECT_EQ(arrangement.projected(), nullptr);
  EXPECT_FALSE(arrangement.seenFromOrigin());
}

TEST(Arrangement, KnowsThatNoSensorSeesWhatIsBehindIt) {
  // As in a camera's link frame: x ahead, z up, half of the points below 0.
  Cloud cloud = shuffledList(kScene.image(6));
  cloud.move(robotFromCamera(0.0, 0.0), DepthRange());
  for (const bool brings_normals : {false, true}) {
    Arrangement arrangement;
    EXPECT_EQ(&arrangement.of(cloud, brings_normals), &cloud);
    EXPECT_FALSE(arrangement.seenFromOrigin());
  }
}

TEST(Arrangement, KnowsThatNoSensorSeesSoFarAside) {
  // The same, but what is behind was cut away.
  Cloud cloud = shuffledList(kScene.image(6));
  cloud.move(robotFromCamera(0.0, 0.0), DepthRange{0.1f, 2.0f});
  ASSERT_EQ(cloud.behind_count, 0u);
  Arrangement arrangement;
  EXPECT_EQ(&arrangement.of(cloud, false), &cloud);
  EXPECT_FALSE(arrangement.seenFromOrigin());
}

TEST(Arrangement, ForgetsWhereTheLastCloudWasSeenFrom) {
  Arrangement arrangement;
  arrangement.of(inFrameOfRobot(kScene.image(2)), false);
  const Cloud list = shuffledList(kScene.image(2));
  EXPECT_TRUE(arrangement.of(list, false).organized());
  EXPECT_TRUE(arrangement.seenFromOrigin());
}

TEST(Arrangement, GivesAListInEightRowsItsImageBack) {
  Cloud cloud = shuffledList(kScene.image(4));
  cloud.width /= 8, cloud.height = 8;
  Arrangement arrangement;
  const Cloud& seen = arrangement.of(cloud, false);
  ASSERT_TRUE(arrangement.projected());
  EXPECT_GT(seen.valid_count, cloud.valid_count / 2);
  EXPECT_TRUE(arrangement.seenFromOrigin());
}

TEST(ImageOfADepthCamera, StaysOneWithAFewPixelsBehindTheSensor) {
  const Cloud image = kScene.image(5);
  Cloud with_strays = image, without = image;
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t i : {std::size_t{7}, image.size() / 2, image.size() - 3}) {
    with_strays.x[i] = with_strays.y[i] = 0.1f, with_strays.z[i] = -0.5f;
    without.x[i] = without.y[i] = without.z[i] = kMissing;
  }
  with_strays.countPoints(), without.countPoints();
  ASSERT_EQ(with_strays.behind_count, 3u);
  Detector one{Params()}, other{Params()};
  const Detections &found = one.detect(with_strays), &expected = other.detect(without);
  EXPECT_TRUE(found.seen_from_origin);
  EXPECT_GT(found.image_noise, 0.0) << "of depth cameras alone this is measured";
  ASSERT_EQ(found.items.size(), expected.items.size());
  ASSERT_GE(found.items.size(), 2u);
  for (std::size_t i = 0; i < found.items.size(); ++i) {
    EXPECT_EQ(found.items[i].extent.origin, expected.items[i].extent.origin);
    EXPECT_EQ(found.items[i].inlier_count, expected.items[i].inlier_count);
  }
}

TEST(CloudOfARobotsFrame, IsSaidToBeOneAndItsWallIsFoundAllTheSame) {
  const Cloud image = inFrameOfRobot(kScene.image(5));
  const Plane wall = {robotFromCamera(2.0, 0.7) * Vec3(0.0, 0.0, kScene.wall),
                      robotFromCamera(2.0, 0.7).linear() * -Vec3::UnitZ()};
  Detector detector{Params()};
  for (const Cloud& cloud : {image, shuffledList(image)}) {
    const Detections& found = detector.detect(cloud);
    EXPECT_FALSE(found.seen_from_origin);
    ASSERT_GE(found.items.size(), 1u);
    const auto smaller = [](const Detection& a, const Detection& b) { return a.inlier_count < b.inlier_count; };
    const auto largest = std::max_element(found.items.begin(), found.items.end(), smaller);
    const Plane* plane = std::get_if<Plane>(&largest->shape);
    ASSERT_TRUE(plane);
    EXPECT_LT(distance(wall, largest->extent.origin), 0.001);
    EXPECT_GT(std::abs(plane->normal.dot(wall.normal)), std::cos(0.005));
  }
  EXPECT_TRUE(detector.detect(kScene.image(5)).seen_from_origin);
}

}  // namespace
}  // namespace primitect::arrangement_test
