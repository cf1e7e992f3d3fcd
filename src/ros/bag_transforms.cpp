// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A buffer that remembers the whole recording.
#include "bag_transforms.h"

#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <stdexcept>

#include "late_transform.h"

namespace primitect::ros_layer {

BagTransforms::BagTransforms(const std::vector<std::unique_ptr<rosbag::Bag>>& bags) try {
  // A transform is forgotten when one that is newer by this has come; ros::Duration has 68 years.
  constexpr double kForever = 2e9;  // s
  transforms_ = std::make_unique<tf2::BufferCore>(ros::Duration(kForever));
  rosbag::View view;
  const std::vector<std::string> topics = {"/tf", "tf", "/tf_static", "tf_static"};
  for (const auto& bag : bags) view.addQuery(*bag, rosbag::TopicQuery(topics));
  for (const rosbag::MessageInstance& recorded : view) {
    const auto message = recorded.instantiate<tf2_msgs::TFMessage>();
    if (!message) continue;  // tf's own type, which has the same fields, has the same sum, too
    const bool is_static = recorded.getTopic().find("static") != std::string::npos;
    for (const auto& transform : message->transforms) transforms_->setTransform(transform, "bag", is_static);
  }
} catch (const rosbag::BagException& error) {
  throw std::runtime_error(std::string("transforms of the recording cannot be read: ") + error.what());
}

Eigen::Isometry3d BagTransforms::lookup(const std::string& target, const std::string& source,
                                        const ros::Time& stamp) const {
  return isometryOf(transforms_->lookupTransform(frameName(target), frameName(source), stamp).transform);
}

}  // namespace primitect::ros_layer
