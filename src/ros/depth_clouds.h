// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A recorded depth image and its camera as a cloud.
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

namespace primitect::ros_layer {

/// The points that depth_image_proc/point_cloud_xyz, the nodelet of depth_image.launch, makes of it, organized, with
/// the image's header. Depths of 16 bits are mm, those of 32 bits m. Throws std::runtime_error saying what is wrong and
/// what was expected: encoding, byte order, sizes, that of the camera (after ROI and binning) among them, focal length.
sensor_msgs::PointCloud2::Ptr cloudOf(const sensor_msgs::ImageConstPtr& depth, const sensor_msgs::CameraInfo& camera);

}  // namespace primitect::ros_layer
