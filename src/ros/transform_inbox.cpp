// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Subscriptions on a queue of their own, and what they file.
#include "transform_inbox.h"

#include <tf2/exceptions.h>

namespace primitect::ros_layer {

void FiledTransforms::file(const tf2_msgs::TFMessage& message, const std::string& publisher, const ros::Time& received,
                           bool is_static) {
  if (received < last_received_) buffer_.clear();  // not what is static
  last_received_ = received;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    try {
      buffer_.setTransform(transform, publisher, is_static);  // says in the log what it does not take
    } catch (const tf2::TransformException& error) {
      ROS_ERROR_STREAM("transform from '" << transform.header.frame_id << "' to '" << transform.child_frame_id
                                          << "' is left out: " << error.what());
    }
  }
}

TransformInbox::TransformInbox(ros::NodeHandle handle, double patience)
    : late_(filed_.buffer(), patience, [this] { take(); }) {
  handle.setCallbackQueue(&queue_);
  moving_ = subscribe(handle, "/tf", false);
  fixed_ = subscribe(handle, "/tf_static", true);
}

ros::Subscriber TransformInbox::subscribe(ros::NodeHandle& handle, const std::string& topic, bool is_static) {
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Event&>(topic, kMostWaiting, [this, is_static](const Event& event) {
    filed_.file(*event.getConstMessage(), event.getPublisherName(), event.getReceiptTime(), is_static);
  });
  return handle.subscribe(options);
}

}  // namespace primitect::ros_layer
