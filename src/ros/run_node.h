// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A nodelet as a plain node with the same private names.
#pragma once

#include <ros/ros.h>

#include <exception>

namespace primitect::ros_layer {

/// Runs the nodelet alone in this process; returns the exit code: 1 when it refused to start.
template <typename NodeletClass>
int runNode(int argc, char** argv, const char* default_name) try {
  ros::init(argc, argv, default_name);
  const ros::NodeHandle keeps_ros_running;
  NodeletClass nodelet;
  nodelet.init(ros::this_node::getName(), ros::names::getRemappings(), {});
  if (!nodelet.started()) return 1;
  ros::spin();
  return 0;
} catch (const std::exception& error) {
  ROS_FATAL_STREAM(default_name << " does not run: " << error.what());
  return 1;
}

}  // namespace primitect::ros_layer
