// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tracks in messages.
#include "ros/tracking.h"

#include <gtest/gtest.h>

#include "ros/geometry_messages.h"

namespace primitect::ros_layer::tracking_test {
namespace {

Primitive primitiveAt(std::uint8_t type, double x) {
  Primitive primitive;
  primitive.type = type;
  primitive.pose.pose.position.x = x;
  primitive.pose.pose.orientation.w = 1.0;
  primitive.radius = type == Primitive::PLANE ? 0.0f : 0.05f;
  primitive.size[0] = primitive.size[1] = type == Primitive::PLANE ? 0.2f : 0.0f;
  return primitive;
}

PrimitiveArray messageAt(double seconds, const std::vector<Primitive>& primitives) {
  PrimitiveArray message;
  message.header.stamp = ros::Time(seconds);
  message.primitives = primitives;
  return message;
}

TEST(Tracks, StandInTheMessage) {
  PrimitiveTracker tracker;
  PrimitiveArray first = messageAt(5.0, {primitiveAt(Primitive::PLANE, 0.0), primitiveAt(Primitive::SPHERE, 0.0)});
  tracker.update(1.0, first);
  EXPECT_EQ(first.primitives[0].track_id, 1u);
  EXPECT_EQ(first.primitives[1].track_id, 2u);
  PrimitiveArray next = messageAt(5.1, {primitiveAt(Primitive::SPHERE, 0.02), primitiveAt(Primitive::PLANE, 0.05),
                                        primitiveAt(Primitive::SPHERE, 0.5)});
  tracker.update(1.0, next);
  EXPECT_EQ(next.primitives[0].track_id, 2u);
  EXPECT_EQ(next.primitives[0].age, 1u);
  EXPECT_EQ(next.primitives[1].track_id, 1u);
  EXPECT_EQ(next.primitives[2].track_id, 3u);
  EXPECT_EQ(next.primitives[2].age, 0u);
}

Vec3 axisOf(const Primitive& primitive, int column) { return Body(primitive).rotation.col(column); }

/// About the origin, in the plane of x and y.
void addHull(const std::vector<Vec3>& corners, Primitive& plane) {
  for (const Vec3& corner : corners) {
    plane.hull.emplace_back();
    plane.hull.back().x = static_cast<float>(corner.x()), plane.hull.back().y = static_cast<float>(corner.y());
  }
}

TEST(Tracks, KeepAxesAndLongerSidesTheWayTheyWere) {
  PrimitiveTracker tracker;
  PrimitiveArray first = messageAt(5.0, {primitiveAt(Primitive::PLANE, 0.0), primitiveAt(Primitive::CYLINDER, 0.5)});
  PrimitiveArray next = messageAt(5.1, first.primitives);
  const Eigen::AngleAxisd about_z(M_PI, Vec3::UnitZ()), about_x(M_PI, Vec3::UnitX());
  next.primitives[0].pose.pose.orientation = quaternionMessage(about_z.toRotationMatrix());
  next.primitives[1].pose.pose.orientation = quaternionMessage(about_x.toRotationMatrix());
  PrimitiveArray again = next;
  again.header.stamp = ros::Time(5.2);
  tracker.update(1.0, first);
  for (PrimitiveArray* message : {&next, &again}) {
    tracker.update(1.0, *message);
    for (int column = 0; column < 3; ++column) {
      EXPECT_LT((axisOf(message->primitives[0], column) - axisOf(first.primitives[0], column)).norm(), 1e-9);
      EXPECT_LT((axisOf(message->primitives[1], column) - axisOf(first.primitives[1], column)).norm(), 1e-9);
    }
  }
}

TEST(Tracks, KeepTheSidesOfAPlaneThatIsAsLongAsWide) {
  PrimitiveTracker tracker;
  Primitive wide = primitiveAt(Primitive::PLANE, 0.0);
  wide.size[0] = 0.21f, wide.size[1] = 0.2f;
  // The other side is the longer one, and x along it.
  Primitive high = wide;
  high.pose.pose.orientation = quaternionMessage(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()).toRotationMatrix());
  // Six corners, of which no side lies along x.
  Primitive round = high;
  round.pose.pose.orientation = quaternionMessage(Eigen::AngleAxisd(M_PI / 6, Vec3::UnitZ()).toRotationMatrix());
  round.size[0] = 0.2f, round.size[1] = 0.173f;
  addHull({{0.1, 0.01, 0}, {0.05, 0.097, 0}, {-0.05, 0.077, 0}, {-0.1, 0.01, 0}, {-0.05, -0.077, 0}, {0.05, -0.077, 0}},
          round);
  PrimitiveArray first = messageAt(5.0, {wide}), second = messageAt(5.1, {high}), third = messageAt(5.2, {round});
  for (PrimitiveArray* message : {&first, &second, &third}) {
    tracker.update(1.0, *message);
    const Primitive& plane = message->primitives[0];
    EXPECT_EQ(plane.track_id, 1u);
    EXPECT_LT((axisOf(plane, 0) - Vec3::UnitX()).norm(), 1e-9);
    EXPECT_LT((axisOf(plane, 2) - Vec3::UnitZ()).norm(), 1e-9);
  }
  EXPECT_FLOAT_EQ(second.primitives[0].size[0], 0.2f);
  EXPECT_FLOAT_EQ(second.primitives[0].size[1], 0.21f);
  EXPECT_FLOAT_EQ(third.primitives[0].size[0], 0.2f);
  EXPECT_FLOAT_EQ(third.primitives[0].size[1], 0.174f);
  EXPECT_NEAR(third.primitives[0].pose.pose.position.y, 0.01, 1e-6);
}

TEST(Tracks, ExchangeTheEndsOfACylinderThatTheyTurnRound) {
  PrimitiveTracker tracker;
  PrimitiveArray first = messageAt(5.0, {primitiveAt(Primitive::CYLINDER, 0.5)});
  PrimitiveArray next = messageAt(5.1, first.primitives);
  Primitive& can = next.primitives[0];
  can.pose.pose.orientation = quaternionMessage(Eigen::AngleAxisd(M_PI, Vec3::UnitX()).toRotationMatrix());
  can.unseen_ends = Primitive::END_AT_MINUS_Z;
  can.face_at_minus_z = Primitive::NO_FACE;
  can.face_at_plus_z = 3;
  for (PrimitiveArray* message : {&first, &next}) tracker.update(1.0, *message);
  EXPECT_EQ(can.unseen_ends, Primitive::END_AT_PLUS_Z);
  EXPECT_EQ(can.face_at_minus_z, 3);
  EXPECT_EQ(can.face_at_plus_z, +Primitive::NO_FACE);
}

TEST(Tracks, EndWhereTheFrameIsAnotherOne) {
  PrimitiveTracker tracker;
  PrimitiveArray there = messageAt(5.0, {primitiveAt(Primitive::SPHERE, 0.0)});
  there.header.frame_id = "camera";
  PrimitiveArray lost = messageAt(5.1, {}), again = there, elsewhere = there;
  lost.header.frame_id = "another";  // without a transform
  elsewhere.header.frame_id = "base_link";
  for (PrimitiveArray* message : {&there, &lost, &again, &elsewhere}) tracker.update(1.0, *message);
  EXPECT_EQ(again.primitives[0].track_id, 1u);
  EXPECT_EQ(elsewhere.primitives[0].track_id, 2u);
}

TEST(Tracks, EndByTheStampsAlsoOfEmptyMessages) {
  PrimitiveTracker tracker;
  PrimitiveArray message = messageAt(5.0, {primitiveAt(Primitive::SPHERE, 0.0)}), empty = messageAt(6.5, {});
  tracker.update(1.0, message);
  tracker.update(1.0, empty);
  message.header.stamp = ros::Time(6.6);
  tracker.update(1.0, message);
  EXPECT_EQ(message.primitives[0].track_id, 2u);
}

}  // namespace
}  // namespace primitect::ros_layer::tracking_test
