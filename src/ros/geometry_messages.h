// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points and rotations of messages as vectors and matrices, and back.
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <primitect/Primitive.h>

#include <Eigen/Geometry>

#include "primitect/primitives.h"

namespace primitect::ros_layer {

/// geometry_msgs/Point and Point32.
template <typename PointMessage>
Vec3 toVec3(const PointMessage& p) {
  return Vec3(p.x, p.y, p.z);
}

inline geometry_msgs::Point pointMessage(const Vec3& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

inline Eigen::Matrix3d toRotation(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
}

/// Of the two quaternions of a rotation the one with w >= 0, so that the same rotation gives the same bytes.
inline geometry_msgs::Quaternion quaternionMessage(const Eigen::Matrix3d& rotation) {
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  geometry_msgs::Quaternion message;
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
  return message;
}

/// A primitive's pose as vectors.
struct Body {
  Vec3 origin;
  Eigen::Matrix3d rotation;
  Vec3 axis;  ///< z of the pose

  explicit Body(const Primitive& primitive)
      : origin(toVec3(primitive.pose.pose.position)),
        rotation(toRotation(primitive.pose.pose.orientation)),
        axis(rotation.col(2)) {}
};

}  // namespace primitect::ros_layer
