// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// tf's transforms, taken when they are asked for: a listener without a thread of its own.
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <Eigen/Geometry>
#include <string>

#include "late_transform.h"

namespace primitect::ros_layer {

class TransformInbox {
 public:
  /// How often take() must be called (s) where nothing is looked up: tf2's listener keeps the last hundred messages.
  static constexpr double kTakeSeconds = 0.05;

  /// Subscribes to /tf and /tf_static. patience (s): how long lookup() waits.
  TransformInbox(const ros::NodeHandle& handle, double patience)
      : listener_(buffer_, queuing(handle), false), late_(buffer_, patience, [this] { take(); }) {}

  void setPatience(double patience) { late_.setPatience(patience); }

  /// Files what has come, in the thread of the caller.
  void take() { queue_.callAvailable(); }

  /// As LateTransforms::lookup().
  Eigen::Isometry3d lookup(const std::string& target, const std::string& source, const ros::Time& stamp) {
    return late_.lookup(target, source, stamp);
  }

 private:
  ros::NodeHandle queuing(ros::NodeHandle handle) {
    handle.setCallbackQueue(&queue_);
    return handle;
  }

  ros::CallbackQueue queue_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  LateTransforms late_;
};

}  // namespace primitect::ros_layer
