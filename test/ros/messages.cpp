// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Detections survive the way into a message and back, and into another frame.
#include "ros/messages.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace primitect::messages_test {
namespace {

using namespace ros_layer;

Eigen::Matrix3d someRotation() { return Eigen::AngleAxisd(2.5, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix(); }

Detection coneDetection() {
  Detection detection;
  Extent& extent = detection.extent;
  extent.rotation = someRotation();
  extent.origin = Vec3(0.1, -0.2, 0.9);
  extent.size = Vec3(0.0, 0.0, 0.25);
  extent.radius = 0.125;
  extent.radius_small = 0.0625;
  extent.unseen_ends = kEndAtPlusZ;
  extent.face_at_minus_z = 7;
  detection.shape = Cone{Vec3(0.1, 0.2, 0.3), extent.rotation.col(2), 0.25};
  detection.votes = 12.5f;
  detection.inlier_count = 77;
  detection.rms_error = 0.002f;
  detection.confidence = 0.75f;
  detection.coverage = 0.5f;
  detection.radius_stddev = 0.001f;
  detection.half_angle_stddev = 0.002f;
  detection.position_stddev = 0.003f;
  detection.axis_stddev = 0.004f;
  for (std::size_t i = 0; i < 36; ++i) detection.covariance[i] = 1.0 + static_cast<double>(i);
  detection.rival = Kind::cylinder;
  detection.concave = true;
  detection.truncated = kTruncatedByDepth | kTruncatedByImage;
  detection.track_id = 5;
  detection.age = 3;
  return detection;
}

Detection planeDetection() {
  Detection detection;
  detection.extent.origin = Vec3(0.0, 0.5, 1.0);
  detection.extent.rotation = someRotation();
  detection.extent.size = Vec3(0.5, 0.25, 0.0);
  for (double angle : {0.0, 2.0, 4.0}) {
    detection.extent.hull.push_back(detection.extent.origin +
                                    detection.extent.rotation * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  detection.shape = Plane{detection.extent.origin, detection.extent.rotation.col(2)};
  return detection;
}

std_msgs::Header someHeader() {
  std_msgs::Header header;
  header.stamp = ros::Time(1, 2);
  header.frame_id = "camera";
  return header;
}

TEST(Messages, KeepStampFrameStatusAndCounts) {
  Detections detections;
  detections.status = Status::too_few_points;
  detections.points_in = 10;
  detections.points_used = 7;
  detections.samples = 5;
  detections.seen_from_origin = false;
  detections.depth_waves = 0.0025;
  const PrimitiveArray message = toMessage(detections, someHeader());
  EXPECT_EQ(message.header.stamp, ros::Time(1, 2));
  EXPECT_EQ(message.header.frame_id, "camera");
  EXPECT_EQ(message.status, PrimitiveArray::TOO_FEW_POINTS);
  EXPECT_EQ(message.points_in, 10u);
  EXPECT_EQ(message.points_used, 7u);
  EXPECT_EQ(message.samples, 5u);
  EXPECT_FALSE(message.seen_from_origin);
  EXPECT_FLOAT_EQ(message.depth_waves, 0.0025f);
  EXPECT_FLOAT_EQ(static_cast<float>(fromMessage(message).depth_waves), 0.0025f);
  EXPECT_EQ(toMessage(Detections(), std_msgs::Header()).depth_waves, -1.0f);
  EXPECT_FALSE(fromMessage(message).seen_from_origin);
  EXPECT_TRUE(toMessage(Detections(), std_msgs::Header()).seen_from_origin);
}

TEST(Messages, HoldUnknownWhereNoStageFilledAField) {
  Detections detections;
  detections.items.resize(1);
  const Primitive message = toMessage(detections, someHeader()).primitives.at(0);
  EXPECT_EQ(message.pose.covariance[0], -1.0);
  EXPECT_EQ(message.radius_stddev, -1.0f);
  EXPECT_EQ(message.half_angle_stddev, -1.0f);
  EXPECT_EQ(message.position_stddev, -1.0f);
  EXPECT_EQ(message.axis_stddev, -1.0f);
  EXPECT_EQ(message.confidence, -1.0f);
  EXPECT_EQ(message.rival, Primitive::NO_RIVAL);
  EXPECT_EQ(message.rms_error, -1.0f);
  EXPECT_EQ(message.coverage, -1.0f);
  EXPECT_EQ(message.truncated, Primitive::TRUNCATED_UNKNOWN);
  EXPECT_EQ(message.unseen_ends, 0) << "has no axis";
  EXPECT_EQ(message.face_at_minus_z, Primitive::NO_FACE);
}

TEST(Messages, PointTheirZAxisAlongTheShape) {
  const Detection detection = coneDetection();
  const Primitive message = toMessage(detection, 4);
  const geometry_msgs::Quaternion& q = message.pose.pose.orientation;
  const Vec3 axis = Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Vec3::UnitZ();
  EXPECT_TRUE(axis.isApprox(std::get<Cone>(detection.shape).axis, 1e-12));
  EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, 1e-12);
  EXPECT_EQ(message.id, 4u);
}

TEST(Messages, GiveBackTheDetections) {
  Detections detections;
  detections.items.push_back(planeDetection());
  detections.items.push_back(coneDetection());
  const Detections back = fromMessage(toMessage(detections, someHeader()));
  ASSERT_EQ(back.items.size(), 2u);
  const Plane& plane = std::get<Plane>(back.items[0].shape);
  EXPECT_TRUE(plane.normal.isApprox(std::get<Plane>(detections.items[0].shape).normal, 1e-9));
  ASSERT_EQ(back.items[0].extent.hull.size(), 3u);
  EXPECT_TRUE(back.items[0].extent.hull[1].isApprox(detections.items[0].extent.hull[1], 1e-6));  // float32
  const Cone& cone = std::get<Cone>(back.items[1].shape);
  EXPECT_TRUE(cone.apex.isApprox(Vec3(0.1, 0.2, 0.3), 1e-9));
  EXPECT_DOUBLE_EQ(cone.half_angle, 0.25);  // a number that float32 holds exactly
  EXPECT_EQ(back.items[1].extent.radius_small, 0.0625);
  EXPECT_EQ(back.items[1].inlier_count, 77u);
  EXPECT_EQ(back.items[1].votes, 12.5f);
  EXPECT_EQ(back.items[1].rms_error, 0.002f);
  EXPECT_EQ(back.items[1].confidence, 0.75f);
  EXPECT_EQ(back.items[1].coverage, 0.5f);
  EXPECT_EQ(back.items[1].radius_stddev, 0.001f);
  EXPECT_EQ(back.items[1].half_angle_stddev, 0.002f);
  EXPECT_EQ(back.items[1].position_stddev, 0.003f);
  EXPECT_EQ(back.items[1].axis_stddev, 0.004f);
  EXPECT_EQ(back.items[1].covariance, detections.items[1].covariance);
  EXPECT_EQ(back.items[1].rival, Kind::cylinder);
  EXPECT_FALSE(back.items[0].rival);
  EXPECT_TRUE(back.items[1].concave);
  EXPECT_EQ(back.items[1].truncated, kTruncatedByDepth | kTruncatedByImage);
  EXPECT_EQ(back.items[1].extent.unseen_ends, kEndAtPlusZ);
  EXPECT_EQ(back.items[1].extent.face_at_minus_z, 7);
  EXPECT_EQ(back.items[1].extent.face_at_plus_z, kNoFace);
  EXPECT_EQ(back.items[1].track_id, 5u);
}

TEST(Messages, RefuseAnUnknownType) {
  PrimitiveArray message;
  message.primitives.resize(1);
  message.primitives[0].type = 4;
  EXPECT_THROW(fromMessage(message), std::invalid_argument);
}

TEST(Messages, MoveToAnotherFrameAsRigidBodies) {
  Detections detections;
  detections.items.push_back(planeDetection());
  detections.items.push_back(coneDetection());
  detections.items[1].covariance.fill(0.0);
  detections.items[1].covariance[0] = 4.0;  // variance along x
  PrimitiveArray message = toMessage(detections, someHeader());
  Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
  move.linear() = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()).toRotationMatrix();  // x becomes y
  move.translation() = Vec3(1.0, 2.0, 3.0);
  transformPrimitives(move, message);
  const Detections moved = fromMessage(message);
  EXPECT_TRUE(std::get<Cone>(moved.items[1].shape).apex.isApprox(move * Vec3(0.1, 0.2, 0.3), 1e-9));
  EXPECT_TRUE(std::get<Plane>(moved.items[0].shape)
                  .normal.isApprox(move.linear() * std::get<Plane>(detections.items[0].shape).normal, 1e-9));
  EXPECT_TRUE(moved.items[0].extent.hull[2].isApprox(move * detections.items[0].extent.hull[2], 1e-6));
  EXPECT_EQ(moved.items[0].covariance[0], -1.0);  // unknown stays unknown
  EXPECT_NEAR(moved.items[1].covariance[0], 0.0, 1e-12);
  EXPECT_NEAR(moved.items[1].covariance[7], 4.0, 1e-12);
}

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

Matrix6 covarianceOf(const Primitive& primitive) { return Eigen::Map<const Matrix6>(primitive.pose.covariance.data()); }

PrimitiveArray messageWithCovariance(const Detection& detection, const Matrix6& covariance) {
  Detections detections;
  detections.items.push_back(detection);
  std::copy(covariance.data(), covariance.data() + 36, detections.items[0].covariance.begin());
  return toMessage(detections, someHeader());
}

/// Errors of position and turn are vectors of the header's frame: in the target they are turned likewise.
TEST(Messages, TurnTheCovarianceWithTheFrame) {
  Matrix6 factor;
  for (int i = 0; i < 36; ++i) factor(i / 6, i % 6) = std::sin(1.0 + i);  // no structure that could hide a mistake
  const Matrix6 covariance = factor * factor.transpose();
  PrimitiveArray message = messageWithCovariance(coneDetection(), covariance);
  Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
  move.linear() = someRotation();
  move.translation() = Vec3(1.0, 2.0, 3.0);
  transformPrimitives(move, message);
  const Matrix6 moved = covarianceOf(message.primitives[0]);
  EXPECT_TRUE(moved.isApprox(moved.transpose(), 1e-12));
  for (int k = 0; k < 12; ++k) {
    const Vec3 shift(std::sin(k), std::cos(2.0 * k), 0.5), turn(0.3, std::sin(3.0 * k), std::cos(k));
    Eigen::Matrix<double, 6, 1> along, along_moved;
    along << shift, turn;
    along_moved << move.linear() * shift, move.linear() * turn;
    EXPECT_NEAR(along_moved.dot(moved * along_moved), along.dot(covariance * along), 1e-9);
  }
}

TEST(Messages, KeepWhatIsSureAboutAPlaneSureInAnotherFrame) {
  const Detection plane = planeDetection();
  constexpr double kVariance = 4e-6, kTurnVariance = 1e-5, kUnobservable = 1e6;
  Matrix6 covariance = Matrix6::Zero();
  const Eigen::Matrix3d& axes = plane.extent.rotation;
  covariance.topLeftCorner<3, 3>() =
      axes * Vec3(kUnobservable, kUnobservable, kVariance).asDiagonal() * axes.transpose();
  covariance.bottomRightCorner<3, 3>() =
      axes * Vec3(kTurnVariance, kTurnVariance, kUnobservable).asDiagonal() * axes.transpose();
  PrimitiveArray message = messageWithCovariance(plane, covariance);
  Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
  move.linear() = Eigen::AngleAxisd(1.0, Vec3(0.2, 0.5, -1.0).normalized()).toRotationMatrix();
  transformPrimitives(move, message);
  const Vec3 normal = std::get<Plane>(fromMessage(message).items[0].shape).normal;
  const Matrix6 moved = covarianceOf(message.primitives[0]);
  // 1e6 has a rounding error of 1e-10 in double, a few of which add up.
  EXPECT_NEAR(normal.dot(moved.topLeftCorner<3, 3>() * normal), kVariance, 5e-9);
  const Vec3 within = normal.unitOrthogonal();
  EXPECT_NEAR(within.dot(moved.bottomRightCorner<3, 3>() * within), kTurnVariance, 5e-9);
  EXPECT_NEAR(within.dot(moved.topLeftCorner<3, 3>() * within), kUnobservable, 1.0);
}

}  // namespace
}  // namespace primitect::messages_test
