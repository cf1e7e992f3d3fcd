// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A buffer that remembers the whole recording.
#include "bag_transforms.h"

#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <stdexcept>

#include "late_transform.h"
#include "recorded_messages.h"

namespace primitect::ros_layer {

BagTransforms::BagTransforms(const std::vector<std::unique_ptr<rosbag::Bag>>& bags) {
  // A transform is forgotten when one that is newer by this has come. Stamps and this together have 32 bits.
  constexpr double kThirtyYears = 1e9;  // s
  transforms_ = std::make_unique<tf2::BufferCore>(ros::Duration(kThirtyYears));
  rosbag::View view;
  const std::vector<std::string> topics = {"/tf", "tf", "/tf_static", "tf_static"};
  for (const auto& bag : bags) view.addQuery(*bag, rosbag::TopicQuery(topics));
  for (const rosbag::MessageInstance& recorded : view) add(recorded);
}

void BagTransforms::add(const rosbag::MessageInstance& recorded) try {
  const auto message = messageOf<tf2_msgs::TFMessage>(recorded);  // that of tf has the same fields, and sum
  const bool is_static = recorded.getTopic().find("static") != std::string::npos;
  for (const auto& transform : message->transforms) {
    ++(transforms_->setTransform(transform, "bag", is_static) ? usable_ : unusable_);
  }
} catch (const std::exception&) {  // of the bag, of a message, of a stamp
  ++unusable_;
}

Eigen::Isometry3d BagTransforms::lookup(const std::string& target, const std::string& source,
                                        const ros::Time& stamp) const {
  if (usable_ == 0) throw std::runtime_error("the recording holds no transforms on /tf or /tf_static");
  return isometryOf(transforms_->lookupTransform(frameName(target), frameName(source), stamp).transform);
}

}  // namespace primitect::ros_layer
