// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What is filed of tf's messages, where time goes back, too.
#include "ros/transform_inbox.h"

#include <gtest/gtest.h>
#include <tf2/exceptions.h>

namespace primitect::transform_inbox_test {
namespace {

using namespace ros_layer;

tf2_msgs::TFMessage from(const std::string& parent, const std::string& child, double seconds, double x) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  geometry_msgs::TransformStamped& transform = message.transforms[0];
  transform.header.frame_id = parent;
  transform.header.stamp = ros::Time(seconds);
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1.0;
  return message;
}

double xAt(const FiledTransforms& filed, const std::string& parent, double seconds) {
  return filed.buffer().lookupTransform(parent, "camera", ros::Time(seconds)).transform.translation.x;
}

/// At 10 Hz for a second; x is the time since then.
void fileASecond(double begin, FiledTransforms& filed) {
  for (int k = 0; k <= 10; ++k) {
    const double at = begin + 0.1 * k;
    filed.file(from("odom", "base", at, at - begin), "test", ros::Time(at), false);
  }
}

TEST(FiledTransforms, AreThoseOfTheirStamps) {
  FiledTransforms filed;
  filed.file(from("base", "camera", 0.0, 10.0), "test", ros::Time(99.0), true);
  fileASecond(100.0, filed);
  EXPECT_NEAR(xAt(filed, "odom", 100.55), 10.55, 1e-6);
  EXPECT_THROW(xAt(filed, "odom", 99.5), tf2::ExtrapolationException);
}

/// All of it waited and is filed at once: when it was received tells that time went back in between.
TEST(FiledTransforms, BeginAnewWhereTimeGoesBackButForWhatIsStatic) {
  FiledTransforms filed;
  filed.file(from("base", "camera", 0.0, 10.0), "test", ros::Time(99.0), true);
  fileASecond(100.0, filed);
  fileASecond(50.0, filed);
  EXPECT_NEAR(xAt(filed, "odom", 50.55), 10.55, 1e-6);
  EXPECT_THROW(xAt(filed, "odom", 100.5), tf2::ExtrapolationException);
  EXPECT_NEAR(xAt(filed, "base", 50.0), 10.0, 1e-9);
}

TEST(FiledTransforms, LeaveOutWhatIsNone) {
  FiledTransforms filed;
  tf2_msgs::TFMessage message = from("odom", "base", 100.0, 1.0);
  message.transforms.push_back(from("odom", "odom", 100.0, 2.0).transforms[0]);
  message.transforms.push_back(from("odom", "camera", 100.0, 3.0).transforms[0]);
  filed.file(message, "test", ros::Time(100.0), false);
  EXPECT_NEAR(xAt(filed, "odom", 100.0), 3.0, 1e-9);
}

}  // namespace
}  // namespace primitect::transform_inbox_test
