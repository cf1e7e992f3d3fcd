// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A simulated depth image as the messages that a depth camera's driver sends.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "synthetic/camera.h"

namespace primitect::ros_layer {

/// One float32 a point, `offset` bytes from its beginning.
sensor_msgs::PointField floatField(const char* name, std::uint32_t offset);

/// Organized, x y z as float32 (m), 16 bytes a point as drivers do; missing points are NaN.
sensor_msgs::PointCloud2Ptr depthCloud(const std_msgs::Header& header, const std::vector<float>& depth,
                                       const synthetic::PinholeCamera& camera);

/// encoding "32FC1": m, NaN = missing; "16UC1": mm, 0 = missing (or beyond 65.5 m).
sensor_msgs::ImagePtr depthImage(const std_msgs::Header& header, const std::vector<float>& depth,
                                 const synthetic::PinholeCamera& camera, const std::string& encoding);

sensor_msgs::CameraInfoPtr cameraInfo(const std_msgs::Header& header, const synthetic::PinholeCamera& camera);

/// The camera's frame (header.frame_id) in the world frame.
geometry_msgs::TransformStamped cameraTransform(const std_msgs::Header& header, const std::string& world_frame,
                                                const Eigen::Isometry3d& world_from_camera);

}  // namespace primitect::ros_layer
