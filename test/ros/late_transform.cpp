// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A cloud may be a little faster than the transform of its stamp.
#include "ros/late_transform.h"

#include <gtest/gtest.h>
#include <tf2/exceptions.h>

#include <chrono>
#include <thread>

#include "ros/steady_time.h"

namespace primitect {
namespace {

using namespace ros_layer;

geometry_msgs::TransformStamped cameraAt(double x, const ros::Time& stamp) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "base";
  transform.header.stamp = stamp;
  transform.child_frame_id = "camera";
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1.0;
  return transform;
}

TEST(LateTransform, IsTakenWhenItArrivesSoonAfterTheCloud) {
  tf2::BufferCore transforms;
  transforms.setTransform(cameraAt(1.0, ros::Time(10, 0)), "test");
  const ros::Time stamp(10, 500000000);
  ASSERT_THROW(transforms.lookupTransform("base", "camera", stamp), tf2::ExtrapolationException);
  std::thread listener([&transforms] {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    transforms.setTransform(cameraAt(2.0, ros::Time(11, 0)), "test");
  });
  double x = 0.0;
  EXPECT_NO_THROW(x = lookupLateTransform(transforms, "base", "camera", stamp).transform.translation.x);
  listener.join();
  EXPECT_NEAR(x, 1.5, 1e-9);  // of the stamp, not the latest
}

TEST(LateTransform, IsNotWaitedForInVainForLong) {
  const tf2::BufferCore transforms;
  const SteadyClock::time_point begin = SteadyClock::now();
  EXPECT_THROW(lookupLateTransform(transforms, "base", "camera", ros::Time(10, 0)), tf2::TransformException);
  EXPECT_GE(secondsSince(begin), kTransformPatienceSeconds);
  EXPECT_LT(secondsSince(begin), 1.0);  // generous, for a loaded machine
}

TEST(LateTransform, DoesNotWaitWhenItIsThere) {
  tf2::BufferCore transforms;
  transforms.setTransform(cameraAt(3.0, ros::Time(10, 0)), "test");
  EXPECT_EQ(lookupLateTransform(transforms, "base", "camera", ros::Time(10, 0)).transform.translation.x, 3.0);
}

}  // namespace
}  // namespace primitect
