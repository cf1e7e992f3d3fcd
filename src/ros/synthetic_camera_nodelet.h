// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The nodelet primitect/synthetic_camera: a depth camera around a tabletop, with the truth.
#pragma once

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synthetic/camera.h"
#include "synthetic/frame.h"
#include "synthetic/world.h"

namespace primitect::ros_layer {

class SyntheticCameraNodelet : public nodelet::Nodelet {
 public:
  ~SyntheticCameraNodelet() override;

  /// False when onInit() refused to start; the log says why.
  bool started() const { return started_; }

 private:
  /// Private parameters; name, range and meaning: the table in the .cpp.
  struct Settings {
    double rate, speed;
    std::uint64_t seed;
    std::size_t replay;
    std::string objects, frame_id, world_frame, depth_encoding;
    std::optional<Eigen::Isometry3d> pose;  ///< world_from_camera where it stands still
    synthetic::PinholeCamera camera;
    synthetic::FrameParams frame;
  };

  void onInit() override;
  void start();
  Settings loadSettings() const;

  void onTimer();
  /// Of the camera's movement.
  double secondsOfFrame() const;
  void publishFrame(const std_msgs::Header& header, const Eigen::Isometry3d& world_from_camera);
  /// A cloud that was rendered once, without copying it, stamped when it leaves: for measuring what comes after.
  void replayFrame(std_msgs::Header header, const Eigen::Isometry3d& world_from_camera);

  bool started_ = false;
  Settings settings_;
  synthetic::World world_;
  std::uint64_t frame_index_ = 0;
  std::vector<sensor_msgs::PointCloud2Ptr> replayed_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
  ros::Publisher points_, image_, info_, truth_;
  ros::Timer timer_;
};

}  // namespace primitect::ros_layer
