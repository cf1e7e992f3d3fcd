// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The nodelet primitect/unpack_depth: compressed depth images, as bags hold them, made into images again.
#pragma once

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>

#include <boost/thread/recursive_mutex.hpp>

#include "steady_time.h"

namespace primitect::ros_layer {

/// ~packed (sensor_msgs/CompressedImage, see compressed_depth.h) becomes ~image (sensor_msgs/Image), while somebody
/// listens. Of what it cannot read a warning tells, and nothing comes out.
class UnpackDepthNodelet : public nodelet::Nodelet {
 public:
  ~UnpackDepthNodelet() override;

 private:
  void onInit() override;
  void onConnectionChange();
  void onPacked(const sensor_msgs::CompressedImageConstPtr& packed);

  boost::recursive_mutex mutex_;
  ros::Publisher image_;
  ros::Subscriber packed_;
  Throttle warning_{5.0};
};

}  // namespace primitect::ros_layer
