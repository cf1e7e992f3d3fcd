// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A cloud that is not searched comes with the reason: what was there and what was expected.
#include "ros/frame_pipeline.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cloud_messages.h"
#include "core/random.h"
#include "ros/synthetic_messages.h"
#include "synthetic/frame.h"
#include "synthetic/poses.h"
#include "synthetic/tabletop.h"

namespace primitect::frame_pipeline_test {
namespace {

using namespace ros_layer;
using sensor_msgs::PointCloud2;

/// The first `count` of 40 points are a grid at 1 m, the others are far away.
PointCloud2 measured(std::uint32_t count) {
  PointCloud2 message = test::plainCloud(8, 5);
  for (std::uint32_t i = 0; i < 40; ++i) {
    test::put(message, i / 8, i % 8, 8, i < count ? 1.0f + 0.01f * static_cast<float>(i % 3) : 50.0f);
  }
  return message;
}

PointCloud2 missing() {
  PointCloud2 message = test::plainCloud(4, 3);
  for (std::uint32_t i = 0; i < 12; ++i) test::put(message, i / 4, i % 4, 8, std::numeric_limits<float>::quiet_NaN());
  return message;
}

/// The problem with a cloud, after a check of the status that goes with it.
std::string problemOf(const PointCloud2& message, std::uint8_t status, const Params& params = Params()) {
  FramePipeline pipeline(params);
  pipeline.times().begin();
  EXPECT_EQ(pipeline.process(message).status, status);
  return pipeline.problem();
}

TEST(FramePipeline, SaysWhatACloudWithoutMeasuredPointsLacks) {
  EXPECT_EQ(
      problemOf(missing(), PrimitiveArray::EMPTY_INPUT),
      "0 of 12 points are measured and between min_depth (0.1 m) and max_depth (2.0 m); expected at least 16; none of "
      "its points is measured");
  EXPECT_NE(problemOf(PointCloud2(), PrimitiveArray::EMPTY_INPUT).find("0 of 0 points"), std::string::npos);
}

TEST(FramePipeline, SaysWhatTooFewPointsLack) {
  Params params;
  params.min_depth = 0.0;
  params.max_depth = 3.0;
  EXPECT_EQ(
      problemOf(measured(15), PrimitiveArray::TOO_FEW_POINTS, params),
      "15 of 40 points are measured and between min_depth (off) and max_depth (3.0 m); expected at least 16; those "
      "measured are at depths from 1 m to 50 m");
}

TEST(FramePipeline, AsksForMillimetresWhereAllPointsAreTooFarForMetres) {
  PointCloud2 message = measured(40);
  for (std::uint32_t i = 0; i < 40; ++i) test::put(message, i / 8, i % 8, 8, 1000.0f + static_cast<float>(i));
  const std::string problem = problemOf(message, PrimitiveArray::EMPTY_INPUT);
  EXPECT_NE(problem.find("depths from 1000 m to 1039 m: are they millimetres?"), std::string::npos) << problem;
  for (std::uint32_t i = 0; i < 40; ++i) test::put(message, i / 8, i % 8, 8, 3.0f);
  const std::string far = problemOf(message, PrimitiveArray::EMPTY_INPUT);
  EXPECT_NE(far.find("depths from 3 m to 3 m"), std::string::npos) << far;
  EXPECT_EQ(far.find("millimetres"), std::string::npos) << far;
}

TEST(FramePipeline, SearchesTheFewestPointsThatItNames) { EXPECT_EQ(problemOf(measured(16), PrimitiveArray::OK), ""); }

TEST(FramePipeline, CountsThePointsOfWhatItRefuses) {
  PointCloud2 message = measured(40);
  message.fields.pop_back();
  FramePipeline pipeline{Params()};
  const PrimitiveArray& answer = pipeline.process(message);
  EXPECT_EQ(answer.status, PrimitiveArray::REJECTED_INPUT);
  EXPECT_EQ(answer.points_in, 40u);
  EXPECT_EQ(answer.points_used, 0u);
}

TEST(FramePipeline, SaysThatAllPointsAreInOnePlace) {
  PointCloud2 message = test::plainCloud(5, 5);
  for (std::uint32_t i = 0; i < 25; ++i) {
    for (const std::uint32_t offset : {0, 4, 8}) test::put(message, i / 5, i % 5, offset, 1.0f);
  }
  EXPECT_EQ(problemOf(message, PrimitiveArray::TOO_FEW_POINTS), "all 25 measured points are in one place");
}

/// A wall at 1 m whose normals have this z.
PointCloud2 withNormals(float normal_z) {
  PointCloud2 message = test::gridCloud<float>(8, 5, {0, 4, 8}, 24, 0);
  for (std::uint32_t i = 0; i < 40; ++i) test::put(message, i / 8, i % 8, 8, 1.0f);
  const char* const names[] = {"normal_x", "normal_y", "normal_z"};
  for (std::uint32_t k = 0; k < 3; ++k) {
    message.fields.push_back(test::makeField(names[k], 12 + 4 * k, sensor_msgs::PointField::FLOAT32));
    for (std::uint32_t i = 0; i < 40; ++i) test::put(message, i / 8, i % 8, 12 + 4 * k, k == 2 ? normal_z : 0.0f);
  }
  return message;
}

TEST(FramePipeline, TellsNormalsThatFaceAway) {
  Params params;
  params.orient_normals = false;
  FramePipeline pipeline(params);
  pipeline.times().begin();
  pipeline.process(withNormals(1.0f));
  EXPECT_TRUE(pipeline.normalsFaceAway());
  pipeline.process(withNormals(-1.0f));
  EXPECT_FALSE(pipeline.normalsFaceAway());
}

TEST(FramePipeline, ForgetsTheProblemOfTheCloudBefore) {
  FramePipeline pipeline{Params()};
  pipeline.times().begin();
  pipeline.process(missing());
  pipeline.process(measured(40));
  EXPECT_EQ(pipeline.problem(), "");
}

TEST(FramePipeline, TellsWhereACloudWasSeenFromOnlyByItsPoints) {
  Params params;
  params.min_depth = params.max_depth = 0.0;
  FramePipeline pipeline(params);
  pipeline.times().begin();
  const auto seenFromOrigin = [&pipeline](const PointCloud2& message) {
    pipeline.process(message);
    return pipeline.seenFromOrigin();
  };
  PointCloud2 behind = measured(40), rejected = behind;
  for (std::uint32_t i = 0; i < 40; ++i) test::put(behind, i / 8, i % 8, 8, -1.0f);
  rejected.fields.pop_back();
  EXPECT_EQ(seenFromOrigin(measured(40)), true);
  EXPECT_EQ(seenFromOrigin(missing()), std::nullopt);
  EXPECT_EQ(seenFromOrigin(behind), false);
  EXPECT_EQ(seenFromOrigin(rejected), std::nullopt);
  EXPECT_EQ(seenFromOrigin(test::plainCloud(4, 3)), std::nullopt) << "too few";
  seenFromOrigin(behind);
  EXPECT_EQ(pipeline.withoutTransform(test::plainCloud(4, 3), "no transform").points_in, 12u);
  EXPECT_EQ(pipeline.seenFromOrigin(), std::nullopt);
}

/// A table, and how its camera stood on a robot.
PointCloud2 tableIn(const Eigen::Isometry3d& frame_from_camera) {
  const synthetic::PinholeCamera camera;
  const synthetic::Frame frame = renderFrame(synthetic::tabletop(1), camera, synthetic::cameraPose(2.0), {}, 1, 0);
  PointCloud2 message = *depthCloud({}, frame.depth, camera);
  sensor_msgs::PointCloud2Iterator<float> x(message, "x"), y(message, "y"), z(message, "z");
  for (; x != x.end(); ++x, ++y, ++z) {
    const Eigen::Vector3d moved = frame_from_camera * Eigen::Vector3d(*x, *y, *z);
    *x = static_cast<float>(moved.x()), *y = static_cast<float>(moved.y()), *z = static_cast<float>(moved.z());
  }
  return message;
}

/// What was expected in the frame of its cloud, where that frame is in the other one; places to so many metres.
void expectSame(const PrimitiveArray& found, const PrimitiveArray& expected,
                const Eigen::Isometry3d& found_from_expected, double most_apart) {
  ASSERT_GE(expected.primitives.size(), 4u);
  ASSERT_EQ(found.primitives.size(), expected.primitives.size());
  const auto placeOf = [](const Primitive& primitive) {
    const auto& p = primitive.pose.pose.position;
    return Eigen::Vector3d(p.x, p.y, p.z);
  };
  for (std::size_t k = 0; k < expected.primitives.size(); ++k) {
    EXPECT_EQ(found.primitives[k].type, expected.primitives[k].type) << k;
    const Eigen::Vector3d place = found_from_expected * placeOf(expected.primitives[k]);
    EXPECT_LT((placeOf(found.primitives[k]) - place).norm(), most_apart) << k;
  }
}

TEST(FramePipeline, SearchesAnImageThatWasMovedFromWhereItsCameraWas) {
  const Eigen::Isometry3d robot_from_camera = synthetic::robotFromCamera(1.3, 0.6);
  FramePipeline pipeline{Params()};
  pipeline.times().begin();
  const PrimitiveArray expected = pipeline.process(tableIn(Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(pipeline.foundCamera());
  const PrimitiveArray found = pipeline.process(tableIn(robot_from_camera));
  ASSERT_TRUE(pipeline.foundCamera());
  EXPECT_EQ(pipeline.seenFromOrigin(), true);
  EXPECT_LT((pipeline.foundCamera()->translation() - robot_from_camera.translation()).norm(), 0.002);
  expectSame(found, expected, robot_from_camera, 0.01);
  pipeline.process(tableIn(Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(pipeline.foundCamera()) << "of the cloud before";
}

/// The measured points alone, in their order.
PointCloud2 asList(const PointCloud2& image) {
  PointCloud2 list = image;
  list.data.clear();
  sensor_msgs::PointCloud2ConstIterator<float> z(image, "z");
  for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i, ++z) {
    const auto point = image.data.begin() + static_cast<std::ptrdiff_t>(i * image.point_step);
    if (!std::isnan(*z)) list.data.insert(list.data.end(), point, point + image.point_step);
  }
  list.width = static_cast<std::uint32_t>(list.data.size() / image.point_step), list.height = 1;
  list.row_step = static_cast<std::uint32_t>(list.data.size());
  return list;
}

/// Its points in another order.
PointCloud2 shuffled(PointCloud2 list) {
  Random random(1);
  const std::size_t step = list.point_step;
  for (std::size_t i = list.width - 1; i > 0; --i) {
    const std::size_t other = random.below(i + 1);
    std::swap_ranges(list.data.begin() + static_cast<std::ptrdiff_t>(i * step),
                     list.data.begin() + static_cast<std::ptrdiff_t>((i + 1) * step),
                     list.data.begin() + static_cast<std::ptrdiff_t>(other * step));
  }
  return list;
}

TEST(FramePipeline, SearchesAListWithoutOrderFromWhereShadowsTell) {
  const Eigen::Isometry3d robot_from_camera = synthetic::robotFromCamera(1.3, 0.6);
  FramePipeline pipeline{Params()};
  pipeline.times().begin();
  const PrimitiveArray expected = pipeline.process(asList(tableIn(robot_from_camera)));
  const PrimitiveArray found = pipeline.process(shuffled(asList(tableIn(robot_from_camera))));
  ASSERT_TRUE(pipeline.foundCamera());
  EXPECT_EQ(pipeline.cameraClue(), CameraClue::shadows);
  EXPECT_EQ(pipeline.seenFromOrigin(), true);
  EXPECT_LT((pipeline.foundCamera()->translation() - robot_from_camera.translation()).norm(), 0.25);
  expectSame(found, expected, Eigen::Isometry3d::Identity(), 0.015);
  pipeline.process(shuffled(asList(tableIn(Eigen::Isometry3d::Identity()))));
  EXPECT_FALSE(pipeline.foundCamera());
  EXPECT_TRUE(pipeline.isListFromOrigin());
}

TEST(FramePipeline, SearchesAListThatWasMovedFromWhereItsOrderTells) {
  const Eigen::Isometry3d robot_from_camera = synthetic::robotFromCamera(1.3, 0.6);
  FramePipeline pipeline{Params()};
  pipeline.times().begin();
  const PrimitiveArray expected = pipeline.process(asList(tableIn(Eigen::Isometry3d::Identity())));
  EXPECT_FALSE(pipeline.foundCamera());
  EXPECT_FALSE(pipeline.isListFromOrigin()) << "it is known, not assumed";
  const PrimitiveArray found = pipeline.process(asList(tableIn(robot_from_camera)));
  ASSERT_TRUE(pipeline.foundCamera());
  EXPECT_EQ(pipeline.cameraClue(), CameraClue::order);
  EXPECT_EQ(pipeline.seenFromOrigin(), true);
  EXPECT_LT((pipeline.foundCamera()->translation() - robot_from_camera.translation()).norm(), 0.002);
  expectSame(found, expected, robot_from_camera, 0.01);
}

/// Labelled points lie on what they belong to, in the frame of the sensor; z of all is as this cloud of the camera's.
void expectSeenAs(const PointCloud2& of_camera, const PointCloud2& message, FramePipeline& pipeline) {
  const Cloud seen = pipeline.seen(message);
  const std::vector<std::uint32_t>& labels = pipeline.pointLabels();
  ASSERT_EQ(seen.size(), labels.size());
  sensor_msgs::PointCloud2ConstIterator<float> z(of_camera, "z");
  std::size_t on = 0, labelled = 0;
  for (std::size_t i = 0; i < seen.size(); ++i, ++z) {
    EXPECT_EQ(std::isnan(seen.z[i]), std::isnan(*z));
    if (std::isnan(*z)) continue;
    EXPECT_NEAR(seen.z[i], *z, 0.005);
    if (labels[i] == 0) continue;
    ++labelled;
    on += std::abs(distance(pipeline.detections().items.at(labels[i] - 1).shape, seen.point(i))) < 0.02 ? 1 : 0;
  }
  EXPECT_GT(labelled, seen.size() / 10);
  EXPECT_EQ(on, labelled);
}

TEST(FramePipeline, ShowsCloudsAsTheSensorSawThem) {
  const PointCloud2 of_camera = tableIn(Eigen::Isometry3d::Identity());
  const Eigen::Isometry3d robot_from_camera = synthetic::robotFromCamera(1.3, 0.6);
  const PointCloud2 moved = tableIn(robot_from_camera);
  FramePipeline pipeline{Params()};
  pipeline.process(of_camera, true);
  expectSeenAs(of_camera, of_camera, pipeline);
  pipeline.process(moved, true, robot_from_camera.inverse());
  expectSeenAs(of_camera, moved, pipeline);
  pipeline.process(moved, true);
  ASSERT_TRUE(pipeline.foundCamera());
  expectSeenAs(of_camera, moved, pipeline);
}

/// 1281 x 961 pixels of a table, with all of its points within the range.
PointCloud2 largeFrame() {
  const synthetic::PinholeCamera camera = synthetic::PinholeCamera().scaledTo(1281, 961);
  const synthetic::Frame frame = renderFrame(synthetic::tabletop(1), camera, synthetic::cameraPose(2.0), {}, 1, 0);
  return *depthCloud({}, frame.depth, camera);
}

std::vector<std::uint8_t> bytesOf(const PrimitiveArray& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

TEST(FramePipeline, FindsTheSameInALargeImageWhetherItReadsAllOfItOrEnough) {
  const PointCloud2 message = largeFrame();
  FramePipeline pipeline{Params()};
  const std::vector<std::uint8_t> without_labels = bytesOf(pipeline.process(message));
  const PrimitiveArray& with_labels = pipeline.process(message, true);
  EXPECT_EQ(bytesOf(with_labels), without_labels);
  EXPECT_GE(with_labels.primitives.size(), 4u);
  EXPECT_EQ(with_labels.points_in, 1281u * 961u);
  EXPECT_EQ(with_labels.points_used % 4, 0u) << "extrapolated";
  EXPECT_EQ(pipeline.pointLabels().size(), 1281u * 961u);
  const PointCloud2 labels = pipeline.labels({});
  EXPECT_EQ(labels.width, 1281u);
  EXPECT_EQ(labels.height, 961u);
}

TEST(FramePipeline, TellsEachStageAlsoAfterItsParametersChanged) {
  FramePipeline pipeline{Params()};
  std::vector<std::string> told;
  pipeline.onStageDone([&told](const char* stage) { told.emplace_back(stage); });
  pipeline.setParams(Params());
  pipeline.times().begin();
  pipeline.process(measured(40));
  ASSERT_GE(told.size(), 3u);
  EXPECT_EQ(told[0], "read");
  EXPECT_EQ(told[1], "sample");
  EXPECT_EQ(told[2], "normals");
}

/// Up to 0.25 m, without any order.
float rubbleDepth(std::uint32_t i) { return 0.001f * static_cast<float>((i * 2654435761u >> 16) % 251); }

/// 160 x 120 points: half of a wall, 1 m away, and beside it rubble, which keeps all rounds busy.
PointCloud2 wallAndRubble() {
  PointCloud2 message = test::plainCloud(160, 120);
  for (std::uint32_t i = 0; i < 160 * 120; ++i) {
    test::put(message, i / 160, i % 160, 0, 0.005f * (static_cast<float>(i % 160) - 79.5f));
    test::put(message, i / 160, i % 160, 4, 0.005f * (static_cast<float>(i / 160) - 59.5f));
    test::put(message, i / 160, i % 160, 8, 1.0f + (i % 160 < 80 ? 0.0f : rubbleDepth(i)));
  }
  return message;
}

std::uint32_t samplesOf(FramePipeline& pipeline, const PointCloud2& message) {
  pipeline.times().begin();
  const std::uint32_t samples = pipeline.process(message).samples;
  pipeline.published();
  return samples;
}

TEST(MaxLatency, ThatNoMachineKeepsTakesSamplesAwayUntilTheFewestAreLeft) {
  Params params;
  FramePipeline unbound(params);
  const std::uint32_t all = samplesOf(unbound, wallAndRubble());
  EXPECT_EQ(unbound.governor(), nullptr);
  params.max_latency = 1e-9;
  FramePipeline bound(params);
  for (int i = 0; i < 12; ++i) EXPECT_LT(samplesOf(bound, wallAndRubble()), all) << "frame " << i;
  // One round is all there is time for.
  EXPECT_EQ(samplesOf(bound, wallAndRubble()), 256u);
  ASSERT_TRUE(bound.governor());
  EXPECT_TRUE(bound.governor()->hopeless());
  EXPECT_EQ(bound.governor()->missed(), 13u);
}

TEST(MaxLatency, IsForgottenWhenTimeStartsAnew) {
  Params params;
  params.max_latency = 1e-9;
  FramePipeline pipeline(params);
  for (int i = 0; i < 12; ++i) samplesOf(pipeline, wallAndRubble());
  ASSERT_LT(pipeline.governor()->share(), 1.0);
  pipeline.startAnew();
  EXPECT_EQ(pipeline.governor()->share(), 1.0);
  EXPECT_EQ(pipeline.governor()->missed(), 0u);
}

TEST(MaxLatency, TakesNoNoticeOfCloudsThatAreNotSearched) {
  Params params;
  params.max_latency = 1e-9;
  FramePipeline pipeline(params);
  for (int i = 0; i < 12; ++i) samplesOf(pipeline, missing());
  EXPECT_EQ(pipeline.governor()->share(), 1.0);
  EXPECT_EQ(pipeline.governor()->frames(), 0u);
}

TEST(MaxLatency, IsTurnedOnAndOffWithTheParameters) {
  Params params;
  FramePipeline pipeline(params);
  params.max_latency = 0.01;
  pipeline.setParams(params);
  ASSERT_TRUE(pipeline.governor());
  EXPECT_EQ(pipeline.governor()->bound(), 0.01);
  pipeline.setParams(Params());
  EXPECT_EQ(pipeline.governor(), nullptr);
}

}  // namespace
}  // namespace primitect::frame_pipeline_test
