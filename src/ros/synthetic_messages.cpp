// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth to cloud, image and calibration messages.
#include "synthetic_messages.h"

#include <tf2_eigen/tf2_eigen.h>

#include <boost/make_shared.hpp>
#include <cstring>

#include "synthetic/millimetres.h"

namespace primitect::ros_layer {
namespace {

constexpr std::uint32_t kPointStep = 16;

}  // namespace

sensor_msgs::PointField floatField(const char* name, std::uint32_t offset) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = sensor_msgs::PointField::FLOAT32;
  field.count = 1;
  return field;
}

sensor_msgs::PointCloud2Ptr depthCloud(const std_msgs::Header& header, const std::vector<float>& depth,
                                       const synthetic::PinholeCamera& camera) {
  auto message = boost::make_shared<sensor_msgs::PointCloud2>();
  message->header = header;
  message->width = static_cast<std::uint32_t>(camera.width);
  message->height = static_cast<std::uint32_t>(camera.height);
  message->fields = {floatField("x", 0), floatField("y", 4), floatField("z", 8)};
  message->point_step = kPointStep;
  message->row_step = kPointStep * message->width;
  message->is_dense = false;
  message->data.resize(std::size_t{message->row_step} * message->height);
  std::uint8_t* out = message->data.data();
  for (std::size_t i = 0; i < depth.size(); ++i, out += kPointStep) {
    const int column = static_cast<int>(i) % camera.width, row = static_cast<int>(i) / camera.width;
    const Eigen::Vector3f point = (camera.ray(column, row) * static_cast<double>(depth[i])).cast<float>();
    std::memcpy(out, point.data(), 3 * sizeof(float));
  }
  return message;
}

sensor_msgs::ImagePtr depthImage(const std_msgs::Header& header, const std::vector<float>& depth,
                                 const synthetic::PinholeCamera& camera, const std::string& encoding) {
  auto message = boost::make_shared<sensor_msgs::Image>();
  const bool in_millimetres = encoding == "16UC1";
  const std::size_t pixel_bytes = in_millimetres ? sizeof(std::uint16_t) : sizeof(float);
  message->header = header;
  message->width = static_cast<std::uint32_t>(camera.width);
  message->height = static_cast<std::uint32_t>(camera.height);
  message->encoding = encoding;
  message->step = static_cast<std::uint32_t>(pixel_bytes) * message->width;
  message->data.resize(pixel_bytes * depth.size());
  if (!in_millimetres) {
    std::memcpy(message->data.data(), depth.data(), message->data.size());
    return message;
  }
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const std::uint16_t value = synthetic::millimetres(depth[i]);
    std::memcpy(message->data.data() + i * sizeof value, &value, sizeof value);
  }
  return message;
}

sensor_msgs::CameraInfoPtr cameraInfo(const std_msgs::Header& header, const synthetic::PinholeCamera& camera) {
  auto message = boost::make_shared<sensor_msgs::CameraInfo>();
  message->header = header;
  message->width = static_cast<std::uint32_t>(camera.width);
  message->height = static_cast<std::uint32_t>(camera.height);
  message->distortion_model = "plumb_bob";
  message->D.assign(5, 0.0);
  message->K = {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
  message->R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  message->P = {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return message;
}

geometry_msgs::TransformStamped cameraTransform(const std_msgs::Header& header, const std::string& world_frame,
                                                const Eigen::Isometry3d& world_from_camera) {
  geometry_msgs::TransformStamped message = tf2::eigenToTransform(world_from_camera);
  message.header = header;
  message.header.frame_id = world_frame;
  message.child_frame_id = header.frame_id;
  return message;
}

}  // namespace primitect::ros_layer
