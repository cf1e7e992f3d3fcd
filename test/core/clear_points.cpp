// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points that only their own shape can have brought there: in images by their labels, elsewhere by place and normal.
#include "core/clear_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/extent.h"
#include "core/far_sides.h"
#include "test/support/exact_shapes.h"
#include "test/support/noisy_points.h"

namespace primitect::clear_points_test {
namespace {

using test::SurfacePoint;

constexpr double kSigma = 0.002;
const NoiseModel kModel = {kSigma, 0.0, 0.3};
const NoiseModel kDepthCamera = {0.0, kSigma, 0.3};
const Plane kFloor = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
const Sphere kBall = {Vec3(0, 0, 0.9), 0.1};

Detection seen(const Shape& shape, const std::vector<SurfacePoint>& patch) {
  std::vector<Vec3> points;
  for (const SurfacePoint& p : patch) points.push_back(p.point);
  Detection detection;
  detection.shape = shape;
  detection.extent = measureExtent(shape, points);
  return detection;
}

List<std::uint32_t> upTo(std::size_t count) {
  List<std::uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

bool contains(const List<std::uint32_t>& indices, std::uint32_t i) {
  return std::find(indices.begin(), indices.end(), i) != indices.end();
}

/// A wall 1 m away, 64 x 48 pixels; the left half of the pixels is labelled 1, the right half 2.
struct TwoHalves {
  static constexpr std::uint32_t kWidth = 64, kHeight = 48;
  Random random{1};
  Cloud cloud;
  std::vector<std::uint32_t> labels;
  List<std::uint32_t> of_left;
  List<bool> has_far_side;
  std::vector<Detection> detections = {seen(kFloor, test::patchOf(kFloor, 100, 0.1, random)),
                                       seen(kFloor, test::patchOf(kFloor, 100, 0.1, random))};

  TwoHalves() {
    cloud.reset(kWidth, kHeight, false);
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
      cloud.setPoint(i, 0.01f * static_cast<float>(i % kWidth), 0.01f * static_cast<float>(i / kWidth), 1.0f, {});
      labels.push_back(i % kWidth < kWidth / 2 ? 1 : 2);
      if (labels.back() == 1) of_left.push_back(i);
    }
  }
  List<std::uint32_t> clear() const {
    return ClearPoints(cloud, {}, detections, {}, labels, has_far_side, kDepthCamera).of(0, of_left);
  }
};

TEST(ClearPoints, OfAnImageAreTwoPixelsOrMoreFromOtherLabels) {
  const TwoHalves halves;
  const List<std::uint32_t> clear = halves.clear();
  // Least radius of the ring: 2 pixels. The border of the image is none of the surface.
  for (const std::uint32_t i : halves.of_left) {
    EXPECT_EQ(contains(clear, i), i % TwoHalves::kWidth < TwoHalves::kWidth / 2 - 2) << i;
  }
}

TEST(ClearPoints, OfAnImageMayBeBesidePixelsThatWereNotMeasured) {
  TwoHalves halves;
  const std::uint32_t beside = 20 * TwoHalves::kWidth + TwoHalves::kWidth / 2 - 1;
  for (std::uint32_t i = 0; i < halves.labels.size(); ++i) {
    if (halves.labels[i] == 2) halves.cloud.z[i] = std::nanf(""), halves.labels[i] = 0;
  }
  EXPECT_TRUE(contains(halves.clear(), beside));
}

TEST(ClearPoints, OfAWallSeenFromBothSidesAreFourPixelsOrMoreFromItsInside) {
  TwoHalves halves;
  halves.has_far_side = {true, false};
  for (std::uint32_t& label : halves.labels) label = label == 2 ? 1 | kFarSide : label;
  const List<std::uint32_t> clear = halves.clear();
  const std::uint32_t row = 20 * TwoHalves::kWidth, border = row + TwoHalves::kWidth / 2;
  EXPECT_FALSE(contains(clear, border - 4));
  EXPECT_TRUE(contains(clear, border - 5));
}

TEST(ClearPoints, AreAllWhereFewWouldBeLeft) {
  TwoHalves halves;
  // A checkerboard leaves nothing.
  for (std::uint32_t i = 0; i < halves.labels.size(); ++i) {
    halves.labels[i] = 1 + (i % TwoHalves::kWidth / 2 + i / TwoHalves::kWidth / 2) % 2;
  }
  EXPECT_EQ(halves.clear(), halves.of_left);
}

/// A floor and a ball that stands on it, without noise.
struct BallOnFloor {
  std::vector<SurfacePoint> points;
  Cloud cloud;
  std::vector<Detection> detections;
  std::vector<std::uint32_t> labels;
  CloudNormals normals;
  static constexpr std::size_t kCount = 2000;

  BallOnFloor() {
    Random random(2);
    const auto floor = test::patchOf(kFloor, kCount, 0.2, random), ball = test::patchOf(kBall, kCount, random);
    points = test::together({floor, ball});
    cloud = test::cloudOf(points);
    detections = {seen(kFloor, floor), seen(kBall, ball)};
    labels.assign(kCount, 1);
    labels.resize(2 * kCount, 2);
  }
  List<std::uint32_t> clearOfFloor() const {
    return ClearPoints(cloud, normals, detections, {}, labels, {}, kModel).of(0, upTo(kCount));
  }
};

TEST(ClearPoints, OfUnorderedPointsAreBeyondTheNoiseOfOtherShapes) {
  const BallOnFloor scene;
  const List<std::uint32_t> clear = scene.clearOfFloor();
  int left_out = 0;
  for (std::uint32_t i = 0; i < BallOnFloor::kCount; ++i) {
    const double away = std::abs(distance(kBall, scene.points[i].point)) / kSigma;
    if (away < 3.0) {
      ++left_out;
      EXPECT_FALSE(contains(clear, i)) << away;
    }
    if (away > 4.0) {
      EXPECT_TRUE(contains(clear, i)) << away;
    }
  }
  EXPECT_GT(left_out, 20);
}

TEST(ClearPoints, OfUnorderedPointsAreNotWhereAnAxisMayGoOn) {
  Random random(4);
  const Cylinder tube = {Vec3(0, 0, 0.95), Vec3(1, 0, 0), 0.05};  // lies on the floor
  constexpr double kReach = 0.1;                                  // m, of the part that was seen, either way
  const auto floor = test::patchOf(kFloor, 4000, 0.2, random);
  const std::vector<Detection> detections = {seen(kFloor, floor),
                                             seen(tube, test::patchOf(tube, 2000, -kReach, kReach, random))};
  const Cloud cloud = test::cloudOf(floor);
  const std::vector<std::uint32_t> labels(floor.size(), 1);
  const List<std::uint32_t> clear =
      ClearPoints(cloud, {}, detections, {}, labels, {}, kModel).of(0, upTo(floor.size()));
  int beyond_what_was_seen = 0, far_beyond = 0;
  for (std::uint32_t i = 0; i < floor.size(); ++i) {
    if (distance(tube, floor[i].point) > 3.0 * kSigma) continue;
    const double along = std::abs(floor[i].point.x());
    beyond_what_was_seen += along > 1.1 * kReach && along < 1.4 * kReach ? 1 : 0;
    far_beyond += along > 1.6 * kReach ? 1 : 0;
    if (along < 1.4 * kReach) {
      EXPECT_FALSE(contains(clear, i)) << along;
    }
    if (along > 1.6 * kReach) {
      EXPECT_TRUE(contains(clear, i)) << along;
    }
  }
  EXPECT_GT(beyond_what_was_seen, 20);
  EXPECT_GT(far_beyond, 20);
}

TEST(ClearPoints, AreNotKeptApartFromWhatIsNotKept) {
  const BallOnFloor scene;
  List<std::uint32_t> of_ball = upTo(BallOnFloor::kCount);
  for (std::uint32_t& i : of_ball) i += BallOnFloor::kCount;
  const auto clearOf = [&](std::size_t detection, const List<bool>& kept) {
    const ClearPoints clear(scene.cloud, scene.normals, scene.detections, kept, scene.labels, {}, kModel);
    return clear.of(detection, detection == 0 ? upTo(BallOnFloor::kCount) : of_ball);
  };
  EXPECT_EQ(clearOf(0, {true, true}), scene.clearOfFloor());
  EXPECT_EQ(clearOf(0, {true, false}).size(), BallOnFloor::kCount);
  const std::vector<Detection> ball = {scene.detections[1]};
  const List<std::uint32_t> alone =
      ClearPoints(scene.cloud, scene.normals, ball, {}, scene.labels, {}, kModel).of(0, of_ball);
  EXPECT_EQ(clearOf(1, {false, true}), alone);
}

TEST(ClearPoints, AreChosenByTheirPlaceOnTheSurfaceWhateverTheNoise) {
  BallOnFloor scene;
  const List<std::uint32_t> before = scene.clearOfFloor();
  // Those that noise takes away from the ball would tilt the floor if they were kept, and the others not.
  Random random(3);
  for (std::size_t i = 0; i < BallOnFloor::kCount; ++i) {
    scene.cloud.z[i] += static_cast<float>(kSigma * random.gaussian());
  }
  EXPECT_EQ(scene.clearOfFloor(), before);
}

TEST(ClearPoints, HaveNormalsLikeTheSurfaceOrNone) {
  BallOnFloor scene;
  const List<std::uint32_t> clear = scene.clearOfFloor();
  const std::uint32_t turned = clear[10], without = clear[20];
  scene.cloud.setNormal(turned, 0.8f, 0.0f, -0.6f);  // 53 deg, beyond the 17 deg of the noise
  scene.cloud.setNormal(without, 0.0f, 0.0f, 0.0f);
  EXPECT_FALSE(contains(scene.clearOfFloor(), turned));
  EXPECT_TRUE(contains(scene.clearOfFloor(), without));
}

TEST(ClearPoints, TurnNormalsToTheSensorOrTakeNoneAsTheSamplesDo) {
  BallOnFloor scene;
  const List<std::uint32_t> clear = scene.clearOfFloor();
  ASSERT_LT(clear.size(), BallOnFloor::kCount);
  for (std::size_t i = 0; i < BallOnFloor::kCount; ++i) scene.cloud.setNormal(i, 0.0f, 0.0f, 1.0f);  // away from it
  EXPECT_EQ(scene.clearOfFloor(), clear);
  scene.normals.towards_sensor = false;
  EXPECT_EQ(scene.clearOfFloor(), upTo(BallOnFloor::kCount));  // none agrees: too few are left
  scene.normals.taken = false;
  EXPECT_EQ(scene.clearOfFloor(), clear);
}

/// Points all around a ball in front of a camera at the origin.
struct WholeBall {
  Cloud cloud;
  std::vector<Detection> detections;
  std::vector<std::uint32_t> labels;
  List<bool> faces_camera;

  explicit WholeBall(bool concave) {
    Random random(4);
    std::vector<SurfacePoint> points;
    for (int k = 0; k < 500; ++k) {
      points.push_back(test::pointOn(kBall, test::randomDirection(random)));
      faces_camera.push_back(points.back().normal.dot(points.back().point) < 0.0);
    }
    cloud = test::cloudOf(points);
    detections = {seen(kBall, points)};
    detections[0].concave = concave;
    labels.assign(points.size(), 1);
  }
};

const Tolerance kTolerance = {NoiseModel{kSigma}, 0.9, 3.0};

TEST(FarSides, LoseTheirLabels) {
  for (const bool concave : {false, true}) {
    WholeBall ball(concave);
    std::vector<std::uint32_t> marked = ball.labels;
    EXPECT_EQ(markFarSides(ball.cloud, ball.detections, {}, kTolerance, labelRuns(marked), marked), List<bool>{true});
    dropFarSides(ball.cloud, ball.detections, kTolerance, ball.labels);
    for (std::size_t i = 0; i < ball.labels.size(); ++i) {
      EXPECT_EQ(marked[i], ball.labels[i] == 1 ? 1 : 1 | kFarSide);
      EXPECT_EQ(ball.labels[i] == 1, ball.faces_camera[i] != concave) << concave << " " << i;
    }
  }
}

TEST(FarSides, BelongToTheOtherSurfaceOfAThinWallWhereThatWasFound) {
  WholeBall ball(false);
  const Sphere inner = {kBall.center, kBall.radius - 0.5 * kSigma};
  ball.detections.push_back(ball.detections[0]);
  ball.detections[1].shape = inner;
  ball.detections[1].concave = true;
  // Noise alone decides which of the two is nearer.
  for (std::size_t i = 0; i < ball.labels.size(); ++i) ball.labels[i] = i % 3 == 0 ? 2 : 1;
  std::vector<std::uint32_t> marked = ball.labels;
  EXPECT_EQ(markFarSides(ball.cloud, ball.detections, {}, kTolerance, labelRuns(marked), marked), List<bool>(2, false));
  for (std::size_t i = 0; i < marked.size(); ++i) EXPECT_EQ(marked[i], ball.faces_camera[i] ? 1u : 2u) << i;
  // One that is not kept, or too far inside, has nothing to do with it.
  marked.assign(marked.size(), 1);
  const List<bool> only_outside = {true, false};
  EXPECT_EQ(markFarSides(ball.cloud, ball.detections, only_outside, kTolerance, labelRuns(marked), marked),
            only_outside);
  for (std::size_t i = 0; i < marked.size(); ++i) EXPECT_EQ(marked[i], ball.faces_camera[i] ? 1u : 1u | kFarSide) << i;
  ball.detections[1].shape = Sphere{kBall.center, kBall.radius - 4.0 * kSigma};
  ball.labels.assign(ball.labels.size(), 1);
  dropFarSides(ball.cloud, ball.detections, kTolerance, ball.labels);
  for (std::size_t i = 0; i < marked.size(); ++i) EXPECT_EQ(ball.labels[i], ball.faces_camera[i] ? 1u : 0u) << i;
}

TEST(FarSides, AreNotTakenFromPlanes) {
  TwoHalves halves;
  const std::vector<std::uint32_t> before = halves.labels;
  EXPECT_EQ(markFarSides(halves.cloud, halves.detections, {}, kTolerance, labelRuns(halves.labels), halves.labels),
            List<bool>(2, false));
  EXPECT_EQ(halves.labels, before);
}

}  // namespace
}  // namespace primitect::clear_points_test
