// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// All transforms of a recording.
#pragma once

#include <rosbag/bag.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

namespace primitect::ros_layer {

/// What /tf and /tf_static say in these bags, from their beginning to their end.
class BagTransforms {
 public:
  /// Throws std::runtime_error where a bag cannot be read.
  explicit BagTransforms(const std::vector<std::unique_ptr<rosbag::Bag>>& bags);

  /// target_from_source at that stamp. Throws what BufferCore::lookupTransform() and isometryOf() throw.
  Eigen::Isometry3d lookup(const std::string& target, const std::string& source, const ros::Time& stamp) const;

 private:
  std::unique_ptr<tf2::BufferCore> transforms_;
};

}  // namespace primitect::ros_layer
