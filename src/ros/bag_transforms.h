// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// All transforms of a recording.
#pragma once

#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

namespace primitect::ros_layer {

/// What /tf and /tf_static say in these bags, from their beginning to their end.
class BagTransforms {
 public:
  explicit BagTransforms(const std::vector<std::unique_ptr<rosbag::Bag>>& bags);

  /// How many messages or transforms could not be read or are none.
  std::size_t unusable() const { return unusable_; }

  /// target_from_source at that stamp. Throws what BufferCore::lookupTransform() and isometryOf() throw, and
  /// std::runtime_error where the bags hold no transforms at all.
  Eigen::Isometry3d lookup(const std::string& target, const std::string& source, const ros::Time& stamp) const;

 private:
  void add(const rosbag::MessageInstance& recorded);

  std::unique_ptr<tf2::BufferCore> transforms_;
  std::size_t usable_ = 0, unusable_ = 0;
};

}  // namespace primitect::ros_layer
