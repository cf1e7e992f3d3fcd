// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The nodelet, the plain node and the core called directly give the same bytes for the same cloud.
#include <gtest/gtest.h>
#include <primitect/PrimitiveArray.h>
#include <ros/ros.h>

#include <map>
#include <string>
#include <vector>

#include "primitect/detector.h"
#include "ros/messages.h"
#include "ros/synthetic_messages.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"

namespace primitect {
namespace {

constexpr int kFrames = 3;
constexpr double kPatienceSeconds = 120.0;  // a loaded machine is slow

/// The bytes of a message without what may differ: the publisher's counter and the time it took.
std::vector<std::uint8_t> comparableBytes(PrimitiveArray message) {
  message.header.seq = 0;
  message.processing_time = 0.0f;
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

class SameResult : public testing::Test {
 protected:
  SameResult() {
    for (const std::string name : {"nodelet", "node"}) {
      subscribers_.push_back(handle_.subscribe<PrimitiveArray>(
          "/" + name + "/primitives", 10,
          [this, name](const PrimitiveArrayConstPtr& message) { answers_[name].push_back(*message); }));
    }
    publisher_ = handle_.advertise<sensor_msgs::PointCloud2>("/cloud", 1);
  }

  bool waitFor(const std::function<bool()>& condition) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatienceSeconds);
    while (!condition() && ros::WallTime::now() < end && ros::ok()) {
      ros::spinOnce();
      ros::WallDuration(0.01).sleep();
    }
    return condition();
  }

  std::vector<float> renderDepth(int frame) const {
    return synthetic::renderFrame(world_, camera_, synthetic::cameraPose(2.0 * frame), {}, 1,
                                  static_cast<std::uint64_t>(frame))
        .depth;
  }

  /// The core on what the camera's own driver would have measured.
  PrimitiveArray fromTheCore(const std::vector<float>& depth, const std_msgs::Header& header) {
    const Params& params = detector_.params();
    Cloud cloud;
    synthetic::cloudFromDepth(depth, camera_, {float(params.min_depth), float(params.max_depth)}, cloud);
    return ros_layer::toMessage(detector_.detect(cloud), header);
  }

  ros::NodeHandle handle_;
  ros::Publisher publisher_;
  std::vector<ros::Subscriber> subscribers_;
  std::map<std::string, std::vector<PrimitiveArray>> answers_;
  synthetic::PinholeCamera camera_;
  synthetic::World world_ = synthetic::tabletop(1);
  Detector detector_{Params()};
};

TEST_F(SameResult, OfNodeletNodeAndCore) {
  ASSERT_TRUE(waitFor([&] { return publisher_.getNumSubscribers() == 2; }));
  ASSERT_TRUE(
      waitFor([&] { return subscribers_[0].getNumPublishers() == 1 && subscribers_[1].getNumPublishers() == 1; }));
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    const std::vector<float> depth = renderDepth(static_cast<int>(frame));
    std_msgs::Header header;
    header.frame_id = "camera";
    header.stamp = ros::Time(100 + static_cast<std::uint32_t>(frame), 7);
    publisher_.publish(ros_layer::depthCloud(header, depth, camera_));
    const auto answered = [&] { return answers_["nodelet"].size() > frame && answers_["node"].size() > frame; };
    ASSERT_TRUE(waitFor(answered)) << "frame " << frame;
    const PrimitiveArray expected = fromTheCore(depth, header);
    EXPECT_FALSE(expected.primitives.empty());
    EXPECT_EQ(comparableBytes(answers_["nodelet"][frame]), comparableBytes(expected));
    EXPECT_EQ(comparableBytes(answers_["node"][frame]), comparableBytes(expected));
    EXPECT_GT(answers_["node"][frame].processing_time, 0.0f);
  }
}

}  // namespace
}  // namespace primitect

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "same_result");
  return RUN_ALL_TESTS();
}
