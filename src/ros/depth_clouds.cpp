// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks around depth_image_proc's conversion, which has none.
#include "depth_clouds.h"

#include <depth_image_proc/depth_conversions.h>
#include <image_geometry/pinhole_camera_model.h>
#include <sensor_msgs/image_encodings.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace primitect::ros_layer {
namespace {

namespace encodings = sensor_msgs::image_encodings;

bool isMillimetres(const std::string& encoding) {
  return encoding == encodings::TYPE_16UC1 || encoding == encodings::MONO16;
}

void checkImage(const sensor_msgs::Image& depth) {
  const bool metres = depth.encoding == encodings::TYPE_32FC1;
  if (!metres && !isMillimetres(depth.encoding)) {
    throw std::runtime_error("the image is '" + depth.encoding +
                             "', expected is one of depths: 16UC1 (mm) or 32FC1 (m)");
  }
  if (depth.is_bigendian) throw std::runtime_error("the image is big-endian, expected is little-endian");
  constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 24;  // as of clouds
  if (std::uint64_t{depth.width} * depth.height > kMostPixels) {
    throw std::runtime_error("the image has " + std::to_string(depth.width) + " x " + std::to_string(depth.height) +
                             " pixels, expected are at most " + std::to_string(kMostPixels));
  }
  const std::uint64_t pixel = metres ? sizeof(float) : sizeof(std::uint16_t);
  const bool rows_fit = depth.step >= pixel * depth.width && depth.step % pixel == 0;
  if (rows_fit && depth.data.size() >= std::uint64_t{depth.step} * depth.height) return;
  throw std::runtime_error("the image says " + std::to_string(depth.width) + " x " + std::to_string(depth.height) +
                           " pixels in rows of " + std::to_string(depth.step) + " bytes, and has " +
                           std::to_string(depth.data.size()) + " bytes");
}

/// Columns or rows of a camera's images.
struct Length {
  std::uint32_t sensor, part, binning;  ///< 0: not told, the whole, none

  std::uint32_t pixels() const { return (part > 0 ? part : sensor) / std::max(binning, 1u); }
  /// What is binned may have been rounded up.
  bool fits(std::uint32_t image) const {
    return pixels() == 0 || image == pixels() || (binning > 1 && image == pixels() + 1);
  }
};

/// What it tells of another size than the image's would put every point elsewhere.
void checkSize(const sensor_msgs::Image& depth, const sensor_msgs::CameraInfo& camera) {
  const Length width = {camera.width, camera.roi.width, camera.binning_x};
  const Length height = {camera.height, camera.roi.height, camera.binning_y};
  const bool empty = depth.width == 0 || depth.height == 0;
  if (empty || (width.fits(depth.width) && height.fits(depth.height))) return;
  throw std::runtime_error("the image has " + std::to_string(depth.width) + " x " + std::to_string(depth.height) +
                           " pixels, and its camera_info is of " + std::to_string(width.pixels()) + " x " +
                           std::to_string(height.pixels()));
}

image_geometry::PinholeCameraModel modelOf(const sensor_msgs::CameraInfo& camera) {
  constexpr std::size_t kFx = 0, kFy = 5;  // in the projection matrix
  if (!(camera.P[kFx] > 0.0) || !(camera.P[kFy] > 0.0)) {
    throw std::runtime_error("its camera_info has no focal length (P[0] and P[5], px)");
  }
  image_geometry::PinholeCameraModel model;
  model.fromCameraInfo(camera);
  return model;
}

}  // namespace

sensor_msgs::PointCloud2::Ptr cloudOf(const sensor_msgs::ImageConstPtr& depth, const sensor_msgs::CameraInfo& camera) {
  checkImage(*depth);
  checkSize(*depth, camera);
  const image_geometry::PinholeCameraModel model = modelOf(camera);
  sensor_msgs::PointCloud2::Ptr cloud(new sensor_msgs::PointCloud2);
  cloud->header = depth->header;
  cloud->height = depth->height;
  cloud->width = depth->width;
  cloud->is_dense = false;
  cloud->is_bigendian = false;
  sensor_msgs::PointCloud2Modifier(*cloud).setPointCloud2FieldsByString(1, "xyz");
  if (depth->width == 0 || depth->height == 0) return cloud;
  if (isMillimetres(depth->encoding)) {
    depth_image_proc::convert<std::uint16_t>(depth, cloud, model);
  } else {
    depth_image_proc::convert<float>(depth, cloud, model);
  }
  return cloud;
}

}  // namespace primitect::ros_layer
