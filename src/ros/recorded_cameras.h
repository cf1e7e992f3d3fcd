// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which camera_info of a recording a depth image has.
#pragma once

#include <rosbag/bag.h>
#include <sensor_msgs/CameraInfo.h>

#include <cstddef>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace primitect::ros_layer {

/// All cameras of a topic. Those of one calibration are kept once.
class RecordedCameras {
 public:
  /// One of an image.
  struct Camera {
    sensor_msgs::CameraInfoConstPtr info;
    bool of_stamp = false;  ///< it has the image's own stamp: nodes wait for these, and hear no image without
  };

  RecordedCameras(const std::vector<std::unique_ptr<rosbag::Bag>>& bags, const std::string& topic);

  /// Of an image with that stamp: the one with the same, of several the one that was recorded at nearly the same time;
  /// else the last one before it, or the first of all. Throws why that one cannot be read, BagDamage where it is the
  /// bag, and std::runtime_error where there is none.
  Camera of(const ros::Time& stamp, const ros::Time& recorded) const;

 private:
  struct Entry {
    ros::Time recorded;
    sensor_msgs::CameraInfoConstPtr info;
    std::exception_ptr problem;
  };

  void add(const rosbag::MessageInstance& recorded);

  std::vector<Entry> entries_;                      ///< in the order of recording
  std::multimap<ros::Time, std::size_t> of_stamp_;  ///< entries that can be read
};

}  // namespace primitect::ros_layer
