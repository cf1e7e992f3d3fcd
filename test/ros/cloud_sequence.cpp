// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Frames, tracks and time of clouds in a row.
#include "ros/cloud_sequence.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/synthetic_messages.h"
#include "synthetic/frame.h"
#include "synthetic/poses.h"
#include "synthetic/tabletop.h"

namespace primitect::cloud_sequence_test {
namespace {

using namespace ros_layer;

/// A wall at 1 m.
sensor_msgs::PointCloud2 wall(const ros::Time& stamp) {
  const synthetic::PinholeCamera camera = synthetic::PinholeCamera().scaledTo(160, 120);
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = stamp;
  return *depthCloud(header, std::vector<float>(camera.pixelCount(), 1.0f), camera);
}

Eigen::Isometry3d ahead(double metres) { return Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, metres)); }

TransformLookup always(double metres) {
  return [metres](const std::string&, const std::string&, const ros::Time&) { return ahead(metres); };
}

Eigen::Isometry3d noTransform(const std::string& target, const std::string& source, const ros::Time&) {
  throw std::runtime_error(target + " is not connected with " + source);
}

/// The answer to the next cloud.
PrimitiveArray answer(CloudSequence& sequence, const ros::Time& stamp) {
  sequence.begin(stamp);
  return sequence.process(wall(stamp));
}

TEST(CloudSequences, TrackThingsFromCloudToCloud) {
  CloudSequence sequence(Params(), noTransform);
  const PrimitiveArray first = answer(sequence, ros::Time(10, 0)), next = answer(sequence, ros::Time(10, 100000000));
  ASSERT_EQ(first.primitives.size(), 1u);
  ASSERT_EQ(next.primitives.size(), 1u);
  EXPECT_EQ(next.primitives[0].track_id, first.primitives[0].track_id);
  EXPECT_EQ(next.primitives[0].age, 1u);
  EXPECT_EQ(next.header.frame_id, "camera");
  EXPECT_GT(next.processing_time, 0.0f);
}

TEST(CloudSequences, TrackNothingWhereTheyAreToldNotTo) {
  Params params;
  params.track = false;
  CloudSequence sequence(params, noTransform);
  answer(sequence, ros::Time(10, 0));
  const PrimitiveArray next = answer(sequence, ros::Time(10, 100000000));
  EXPECT_EQ(next.primitives.at(0).track_id, 0u);
  EXPECT_EQ(next.primitives.at(0).age, 0u);
}

/// A table, as seen from a robot's head, in the frame of its feet.
sensor_msgs::PointCloud2 movedImage() {
  const synthetic::PinholeCamera camera = synthetic::PinholeCamera().scaledTo(320, 240);
  std_msgs::Header header;
  header.frame_id = "base";
  sensor_msgs::PointCloud2 cloud = *depthCloud(
      header, synthetic::renderFrame(synthetic::tabletop(2), camera, synthetic::cameraPose(0.0), {}, 2, 0).depth,
      camera);
  const Eigen::Isometry3f base_from_camera = synthetic::robotFromCamera(1.3, 0.6).cast<float>();
  sensor_msgs::PointCloud2Iterator<float> point(cloud, "x");
  for (std::uint32_t i = 0; i < cloud.width * cloud.height; ++i, ++point) {
    const Eigen::Vector3f moved = base_from_camera * Eigen::Vector3f(point[0], point[1], point[2]);
    std::copy(moved.begin(), moved.end(), &point[0]);
  }
  return cloud;
}

TEST(CloudSequences, LookForNoCameraWhereItIsSaidToBe) {
  CloudSequence looking(Params(), noTransform);
  looking.begin(ros::Time(1));
  looking.process(movedImage());
  ASSERT_TRUE(looking.pipeline().foundCamera());
  EXPECT_NEAR(looking.sensorPose().translation().z(), 1.3, 0.01);
  Params params;
  params.sensor_frame = "/base";
  CloudSequence told(params, noTransform);
  told.begin(ros::Time(1));
  EXPECT_EQ(told.process(movedImage()).status, PrimitiveArray::OK);
  EXPECT_FALSE(told.pipeline().foundCamera());
}

TEST(CloudSequences, BeginAnewWhereTimeGoesBackByMoreThanClouds) {
  CloudSequence sequence(Params(), noTransform);
  answer(sequence, ros::Time(10, 0));
  answer(sequence, ros::Time(10, 500000000));
  EXPECT_FALSE(sequence.begin(ros::Time(10, 450000000)));  // a little out of order
  EXPECT_EQ(answer(sequence, ros::Time(10, 500000000)).primitives.at(0).age, 2u);
  const std::optional<double> back = sequence.begin(ros::Time(8, 0));
  ASSERT_TRUE(back);
  EXPECT_NEAR(*back, 2.5, 1e-6);
  EXPECT_EQ(sequence.process(wall(ros::Time(8, 0))).primitives.at(0).age, 0u);
}

TEST(CloudSequences, TellPrimitivesInTheTargetFrameAndWhereTheSensorIsThere) {
  Params params;
  params.target_frame = "base";
  CloudSequence sequence(params, always(0.5));
  const PrimitiveArray message = answer(sequence, ros::Time(10, 0));
  EXPECT_EQ(message.header.frame_id, "base");
  EXPECT_NEAR(message.primitives.at(0).pose.pose.position.z, 1.5, 1e-4);
  EXPECT_EQ(sequence.sensorPose().translation(), Vec3(0.0, 0.0, 0.5));
  EXPECT_EQ(sequence.sensorHeader().frame_id, "camera");
  EXPECT_EQ(sequence.frameProblem(), "");
}

TEST(CloudSequences, TellTheTargetFrameWithoutASlashBeforeIt) {
  Params params;
  params.target_frame = "/base";
  CloudSequence sequence(params, always(0.5));
  EXPECT_EQ(answer(sequence, ros::Time(10, 0)).header.frame_id, "base");
}

TEST(CloudSequences, SearchInTheSensorsFrameAndTellInThatOfTheCloud) {
  Params params;
  params.sensor_frame = "optical";
  // Clouds are .25 m ahead of the sensor's frame, and back.
  const auto lookup = [](const std::string& target, const std::string&, const ros::Time&) {
    return ahead(target == "optical" ? 0.25 : -0.25);
  };
  CloudSequence sequence(params, lookup);
  const PrimitiveArray message = answer(sequence, ros::Time(10, 0));
  EXPECT_EQ(message.header.frame_id, "camera");
  EXPECT_NEAR(message.primitives.at(0).pose.pose.position.z, 1.0, 1e-4);
  EXPECT_EQ(sequence.sensorHeader().frame_id, "optical");
}

TEST(CloudSequences, SayWhichFramesAreNotConnected) {
  Params params;
  params.target_frame = "map";
  CloudSequence to_map(params, noTransform);
  const PrimitiveArray lost = answer(to_map, ros::Time(10, 0));
  EXPECT_EQ(lost.status, PrimitiveArray::NO_TRANSFORM);
  EXPECT_TRUE(lost.primitives.empty());
  EXPECT_EQ(to_map.problem(), "");
  EXPECT_EQ(to_map.frameProblem(),
            "no transform from 'camera' to target_frame 'map': map is not connected with camera");
  params.target_frame = "";
  params.sensor_frame = "optical";
  CloudSequence from_optical(params, noTransform);
  EXPECT_EQ(answer(from_optical, ros::Time(10, 0)).status, PrimitiveArray::NO_TRANSFORM);
  EXPECT_EQ(from_optical.problem(),
            "no transform from 'camera' to sensor_frame 'optical': optical is not connected with camera");
  EXPECT_EQ(from_optical.frameProblem(), "");
}

}  // namespace
}  // namespace primitect::cloud_sequence_test
