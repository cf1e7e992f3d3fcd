// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A nodelet as a plain node with the same private names.
#pragma once

#include <ros/ros.h>

#include <exception>
#include <iostream>
#include <string>

namespace primitect::ros_layer {

/// Runs the nodelet alone in this process; returns the exit code: 1 when it refused to start, 2 when the command line
/// has more than names and parameters. about: what --help says.
template <typename NodeletClass>
int runNode(int argc, char** argv, const char* default_name, const char* about) try {
  for (int k = 1; k < argc; ++k) {
    if (argv[k] != std::string("--help") && argv[k] != std::string("-h")) continue;
    std::cout << about;
    return 0;
  }
  ros::init(argc, argv, default_name);
  if (argc > 1) {  // names and parameters are gone by now
    std::cerr << default_name << ": what is '" << argv[1] << "'? See --help.\n";
    return 2;
  }
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
