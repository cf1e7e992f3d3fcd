// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tracks in messages.
#include "ros/tracking.h"

#include <gtest/gtest.h>

#include "ros/geometry_messages.h"

namespace primitect::ros_layer {
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

TEST(Tracks, KeepAxesAndLongerSidesTheWayTheyWere) {
  PrimitiveTracker tracker;
  PrimitiveArray first = messageAt(5.0, {primitiveAt(Primitive::PLANE, 0.0), primitiveAt(Primitive::CYLINDER, 0.5)});
  PrimitiveArray next = messageAt(5.1, first.primitives);
  next.primitives[0].pose.pose.orientation = quaternionMessage(halfTurn(Kind::plane).toRotationMatrix());
  next.primitives[1].pose.pose.orientation = quaternionMessage(halfTurn(Kind::cylinder).toRotationMatrix());
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
}  // namespace primitect::ros_layer
