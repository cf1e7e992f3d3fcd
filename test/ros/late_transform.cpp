// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A cloud may be a little faster than the transform of its stamp.
#include "ros/late_transform.h"

#include <gtest/gtest.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "ros/steady_time.h"

namespace primitect::late_transform_test {
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

const double kPatience = Params().transform_patience;  // s

/// x of a transform that arrives so long after it was asked for.
double lookedUp(std::chrono::milliseconds after, double patience) {
  tf2::BufferCore transforms;
  transforms.setTransform(cameraAt(1.0, ros::Time(10, 0)), "test");
  const ros::Time stamp(10, 500000000);
  EXPECT_THROW(transforms.lookupTransform("base", "camera", stamp), tf2::ExtrapolationException);
  std::thread listener([&transforms, after] {
    std::this_thread::sleep_for(after);
    transforms.setTransform(cameraAt(2.0, ros::Time(11, 0)), "test");
  });
  double x = 0.0;
  EXPECT_NO_THROW(x = LateTransforms(transforms, patience).lookup("base", "camera", stamp).translation().x());
  listener.join();
  return x;
}

TEST(LateTransform, IsTakenWhenItArrivesSoonAfterTheCloud) {
  EXPECT_NEAR(lookedUp(std::chrono::milliseconds(10), kPatience), 1.5, 1e-9);  // of the stamp, not the latest
}

TEST(LateTransform, IsTakenFromWhatIsListenedToWhileItWaits) {
  tf2::BufferCore transforms;
  int listened = 0;
  const auto listen = [&] { transforms.setTransform(cameraAt(2.0, ros::Time(10 + ++listened, 0)), "test"); };
  LateTransforms late(transforms, 10.0, listen);
  EXPECT_NEAR(late.lookup("base", "camera", ros::Time(11, 0)).translation().x(), 2.0, 1e-9);
  EXPECT_EQ(listened, 1) << "before the first look";
  EXPECT_NO_THROW(late.lookup("base", "camera", ros::Time(13, 0)));
  EXPECT_EQ(listened, 3) << "and again while it waits";
}

TEST(LateTransform, IsTakenWhenItArrivesLaterWherePatienceIsLonger) {
  EXPECT_NEAR(lookedUp(std::chrono::milliseconds(100), 2.0), 1.5, 1e-9);
}

TEST(LateTransform, IsNotWaitedForInVainForLong) {
  const tf2::BufferCore transforms;
  const SteadyClock::time_point begin = SteadyClock::now();
  EXPECT_THROW(LateTransforms(transforms).lookup("base", "camera", ros::Time(10, 0)), tf2::TransformException);
  EXPECT_GE(secondsSince(begin), kPatience);
  EXPECT_LT(secondsSince(begin), 1.0);  // generous, for a loaded machine
}

double secondsWithout(LateTransforms& transforms, const ros::Time& stamp) {
  const SteadyClock::time_point begin = SteadyClock::now();
  EXPECT_THROW(transforms.lookup("base", "camera", stamp), tf2::TransformException);
  return secondsSince(begin);
}

/// Waits as often as it may, then not at all: the least of several, as a loaded machine may hold up any of them.
void expectFewWaits(LateTransforms& transforms, const ros::Time& stamp) {
  for (int i = 0; i < kWaitsInVain; ++i) EXPECT_GE(secondsWithout(transforms, stamp), kPatience);
  double least = 1.0;
  for (int i = 0; i < 5; ++i) least = std::min(least, secondsWithout(transforms, stamp + ros::Duration(i)));
  EXPECT_LT(least, 0.5 * kPatience);
}

TEST(LateTransform, IsWaitedForAFewTimesOnlyUntilSomethingComes) {
  tf2::BufferCore buffer;
  LateTransforms transforms(buffer);
  expectFewWaits(transforms, ros::Time(10, 0));
  for (const int seconds : {12, 14}) {  // a publisher that falls silent twice
    buffer.setTransform(cameraAt(1.0, ros::Time(seconds, 0)), "test");
    expectFewWaits(transforms, ros::Time(seconds, 500000000));
  }
}

TEST(LateTransform, IsWaitedForStillAfterOtherFramesWereInVain) {
  tf2::BufferCore buffer;
  LateTransforms transforms(buffer);
  for (int i = 0; i < kWaitsInVain; ++i) {
    EXPECT_THROW(transforms.lookup("base", "nobody", ros::Time(10, 0)), tf2::TransformException);
  }
  EXPECT_GE(secondsWithout(transforms, ros::Time(10, 0)), kPatience);
}

TEST(LateTransform, IsNotWaitedForWhereItIsForgottenAlready) {
  tf2::BufferCore buffer;
  LateTransforms transforms(buffer);
  double least = 1.0;
  for (int i = 0; i < 5; ++i) {
    buffer.setTransform(cameraAt(1.0, ros::Time(100 + i, 0)), "test");
    least = std::min(least, secondsWithout(transforms, ros::Time(50 + i, 0)));
  }
  EXPECT_LT(least, 0.5 * kPatience);
}

TEST(LateTransform, DoesNotWaitWhenItIsThere) {
  tf2::BufferCore transforms;
  transforms.setTransform(cameraAt(3.0, ros::Time(10, 0)), "test");
  EXPECT_EQ(LateTransforms(transforms).lookup("base", "camera", ros::Time(10, 0)).translation().x(), 3.0);
}

/// About a slanted axis, with a quaternion this long.
geometry_msgs::Transform turnedBy(double angle, double length) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0));
  geometry_msgs::Transform transform;
  transform.translation.y = 2.0;
  transform.rotation.x = length * turn.x(), transform.rotation.y = length * turn.y();
  transform.rotation.z = length * turn.z(), transform.rotation.w = length * turn.w();
  return transform;
}

TEST(IsometryOf, AQuaternionOfAnyLengthIsItsRotation) {
  for (const double length : {0.1, 0.995, 1.0, 1.005, 3.0}) {
    const Eigen::Isometry3d isometry = isometryOf(turnedBy(0.7, length));
    const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0);
    EXPECT_LT((isometry.linear() - turn.toRotationMatrix()).norm(), 1e-12) << length;
    EXPECT_EQ(isometry.translation(), Eigen::Vector3d(0.0, 2.0, 0.0));
  }
}

std::string problemOf(const geometry_msgs::Transform& transform) try {
  isometryOf(transform);
  return "";
} catch (const std::invalid_argument& error) {
  return error.what();
}

TEST(IsometryOf, WhatIsNoRotationOrNoPlaceIsRefusedWithItsNumbers) {
  EXPECT_EQ(problemOf(turnedBy(0.7, 1.0)), "");
  EXPECT_NE(problemOf(turnedBy(0.7, 0.0)).find("rotation is (0, 0, 0, 0)"), std::string::npos);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  geometry_msgs::Transform transform = turnedBy(0.7, 1.0);
  for (const double value : {kNan, kInfinity}) {
    transform.rotation.z = value;
    EXPECT_NE(problemOf(transform).find("rotation is ("), std::string::npos);
  }
  transform = turnedBy(0.7, 1.0);
  transform.translation.x = kNan;
  EXPECT_NE(problemOf(transform).find("translation is (nan, 2, 0)"), std::string::npos);
}

TEST(LateTransform, KeepsLengthsAlsoWhereTf2TookALongerQuaternion) {
  tf2::BufferCore transforms;
  geometry_msgs::TransformStamped transform = cameraAt(1.0, ros::Time(10, 0));
  transform.transform.rotation = turnedBy(0.7, 1.004).rotation;
  ASSERT_TRUE(transforms.setTransform(transform, "test"));
  const Eigen::Matrix3d turn = LateTransforms(transforms).lookup("base", "camera", ros::Time(10, 0)).linear();
  EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

}  // namespace
}  // namespace primitect::late_transform_test
