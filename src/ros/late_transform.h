// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A transform that may arrive a little later than the cloud it belongs to.
#pragma once

#include <geometry_msgs/Transform.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <string>

namespace primitect::ros_layer {

/// Drivers and localization send the transform of a stamp shortly after the cloud; longer is no jitter (s).
constexpr double kTransformPatienceSeconds = 0.05;

/// The name of a frame as tf2 knows it: without the slash that tf put in front of it.
inline std::string frameName(const std::string& frame) { return frame.rfind('/', 0) == 0 ? frame.substr(1) : frame; }

/// With the rotation that the quaternion means, whatever its length: not all publishers normalise theirs, and tf2 takes
/// those that are a little off. Throws std::invalid_argument where it has no direction, or where the place is no
/// number.
Eigen::Isometry3d isometryOf(const geometry_msgs::Transform& transform);

/// target_from_source at that stamp; another thread must fill the buffer. Waits by the steady clock, at most for
/// kTransformPatienceSeconds, so that a simulated time that stands still blocks nothing.
/// Throws what BufferCore::lookupTransform() throws when there is none by then, and what isometryOf() throws.
Eigen::Isometry3d lookupLateTransform(const tf2::BufferCore& transforms, const std::string& target,
                                      const std::string& source, const ros::Time& stamp);

}  // namespace primitect::ros_layer
