// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// tf's transforms, taken when they are asked for: a listener without a thread of its own.
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <string>

#include "late_transform.h"

namespace primitect::ros_layer {

/// What is known of frames from tf's messages.
class FiledTransforms {
 public:
  /// In the order in which they were received. Where that time went back (a bag that starts again, a reset simulation),
  /// what moved before is forgotten first, as by tf2_ros::TransformListener.
  void file(const tf2_msgs::TFMessage& message, const std::string& publisher, const ros::Time& received,
            bool is_static);

  const tf2::BufferCore& buffer() const { return buffer_; }

 private:
  tf2::BufferCore buffer_;
  ros::Time last_received_;
};

/// Not tf2_ros::TransformListener: that one has a thread, or, without, keeps a hundred messages until they are taken, a
/// tenth of a second of a large robot's, and takes their time for that when they came.
class TransformInbox {
 public:
  /// How often take() should be called (s) where nothing is looked up: of more than kMostWaiting messages the oldest
  /// go.
  static constexpr double kTakeSeconds = 0.05;
  static constexpr std::uint32_t kMostWaiting = 10000;

  /// Subscribes to /tf and /tf_static. patience (s): how long lookup() waits.
  TransformInbox(ros::NodeHandle handle, double patience);

  void setPatience(double patience) { late_.setPatience(patience); }

  /// Files what has come, in the thread of the caller.
  void take() { queue_.callAvailable(); }

  /// As LateTransforms::lookup().
  Eigen::Isometry3d lookup(const std::string& target, const std::string& source, const ros::Time& stamp) {
    return late_.lookup(target, source, stamp);
  }

 private:
  using Event = ros::MessageEvent<const tf2_msgs::TFMessage>;

  ros::Subscriber subscribe(ros::NodeHandle& handle, const std::string& topic, bool is_static);

  FiledTransforms filed_;
  LateTransforms late_;
  ros::CallbackQueue queue_;
  ros::Subscriber moving_, fixed_;
};

}  // namespace primitect::ros_layer
