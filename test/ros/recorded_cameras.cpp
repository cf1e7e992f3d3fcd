// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which camera_info an image has: by stamps, else by when they were recorded.
#include "ros/recorded_cameras.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/recorded_messages.h"
#include "test/io/temporary_folder.h"

namespace primitect::recorded_cameras_test {
namespace {

using namespace ros_layer;

constexpr const char* kTopic = "/camera/camera_info";

ros::Time at(double seconds) { return ros::Time(1000.0 + seconds); }

sensor_msgs::CameraInfo camera(double stamp, double focal_length) {
  sensor_msgs::CameraInfo camera;
  camera.header.stamp = at(stamp);
  camera.distortion_model = "plumb_bob";
  camera.P[0] = focal_length;
  return camera;
}

class RecordedCamera : public test::TemporaryFolder {
 protected:
  struct Recorded {
    double when, stamp, focal_length;
  };

  std::string bagOf(const std::vector<Recorded>& cameras) const {
    rosbag::Bag bag(path("cameras.bag"), rosbag::bagmode::Write);
    for (const auto& [when, stamp, focal_length] : cameras) bag.write(kTopic, at(when), camera(stamp, focal_length));
    return path("cameras.bag");
  }

  /// The last one's distortion model says of its length that it goes on beyond the message.
  void damageLast() const {
    std::string bytes = read(path("cameras.bag"));
    const std::size_t length = bytes.rfind(test::bytesOf<std::uint32_t>({9}) + "plumb_bob");
    ASSERT_NE(length, std::string::npos);
    bytes[length + 2] = '\x7f';
    write("cameras.bag", bytes);
  }

  static RecordedCameras camerasOf(const std::string& path) {
    std::vector<std::unique_ptr<rosbag::Bag>> bags;
    bags.push_back(std::make_unique<rosbag::Bag>(path));
    return RecordedCameras(bags, kTopic);
  }
};

TEST_F(RecordedCamera, HasTheStampOfTheImageThoughItWasRecordedAfterIt) {
  const RecordedCameras cameras = camerasOf(bagOf({{0.0, 0.0, 100}, {0.2, 0.1, 200}, {0.4, 0.2, 300}}));
  const RecordedCameras::Camera found = cameras.of(at(0.1), at(0.1));
  EXPECT_EQ(found.info->P[0], 200);
  EXPECT_TRUE(found.of_stamp);
}

TEST_F(RecordedCamera, OfSeveralOfOneStampWasRecordedAtNearlyTheSameTime) {
  const RecordedCameras cameras = camerasOf(bagOf({{0.0, 0.0, 100}, {5.0, 0.0, 200}, {9.0, 0.0, 300}}));
  EXPECT_EQ(cameras.of(at(0.0), at(4.9)).info->P[0], 200);
  EXPECT_EQ(cameras.of(at(0.0), at(8.0)).info->P[0], 300);
}

TEST_F(RecordedCamera, OfNoImagesStampIsTheLastBeforeItOrElseTheFirst) {
  const RecordedCameras cameras = camerasOf(bagOf({{1.0, 1.0, 100}, {2.0, 2.0, 200}, {3.0, 3.0, 300}}));
  EXPECT_EQ(cameras.of(at(2.5), at(2.5)).info->P[0], 200);
  EXPECT_EQ(cameras.of(at(0.5), at(0.5)).info->P[0], 100);
  EXPECT_EQ(cameras.of(at(9.0), at(9.0)).info->P[0], 300);
  EXPECT_FALSE(cameras.of(at(9.0), at(9.0)).of_stamp);
}

TEST_F(RecordedCamera, ThatCannotBeReadIsNotReplacedByAnOlderOne) {
  const std::string bag = bagOf({{0.0, 0.0, 100}, {1.0, 1.0, 200}});
  damageLast();
  const RecordedCameras cameras = camerasOf(bag);
  EXPECT_EQ(cameras.of(at(0.0), at(1.5)).info->P[0], 100);
  EXPECT_THROW(cameras.of(at(1.0), at(1.5)), BagDamage);
  EXPECT_THROW(cameras.of(at(7.0), at(7.0)), BagDamage);
}

TEST_F(RecordedCamera, MayBeMissing) {
  rosbag::Bag(path("cameras.bag"), rosbag::bagmode::Write).close();
  EXPECT_THROW(camerasOf(path("cameras.bag")).of(at(0.0), at(0.0)), std::runtime_error);
}

}  // namespace
}  // namespace primitect::recorded_cameras_test
