// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Clouds of a recording, in the order in which they were recorded.
#pragma once

#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bag_job.h"
#include "recorded_cameras.h"

namespace primitect::ros_layer {

struct RecordedCloud {
  ros::Time recorded;
  std::optional<std_msgs::Header> header;  ///< none: not even this could be read
  sensor_msgs::PointCloud2ConstPtr cloud;  ///< null: it could not be read
  std::string problem;                     ///< why
  bool damaged = false;                    ///< it is the bag that cannot be read there
  bool camera_of_other_stamp = false;      ///< made of a depth image that no camera_info has the stamp of
};

class BagClouds {
 public:
  /// Opens the bags, the parts of one recording, and looks for the topic. Throws std::runtime_error naming bag and
  /// cause, or the topics that there are; or when there is no cloud in the job's time.
  explicit BagClouds(const BagJob& job);

  const std::string& topic() const { return topic_; }

  void forEach(const std::function<void(const RecordedCloud&)>& use) const;

  const std::vector<std::unique_ptr<rosbag::Bag>>& bags() const { return bags_; }

 private:
  void chooseTopic(const BagJob& job, const std::vector<const rosbag::ConnectionInfo*>& connections);
  void read(const rosbag::MessageInstance& recorded, RecordedCloud& cloud) const;

  std::vector<std::unique_ptr<rosbag::Bag>> bags_;
  std::string topic_, camera_info_;         ///< the latter of depth images only
  std::optional<RecordedCameras> cameras_;  ///< of these
  ros::Time begin_ = ros::TIME_MIN, end_ = ros::TIME_MAX;
};

}  // namespace primitect::ros_layer
