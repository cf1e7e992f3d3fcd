// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// PointCloud2 messages filled byte by byte, without padding.
#include "output_clouds.h"

#include <cstring>

#include "io/label_colors.h"

namespace primitect::ros_layer {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr std::uint32_t kNumberBytes = 4;  // every field is a float32 or a uint32

struct FieldName {
  const char* name;
  std::uint8_t datatype;
};

PointCloud2 makeCloud(const std_msgs::Header& header, std::uint32_t width, std::uint32_t height,
                      const std::vector<FieldName>& names) {
  PointCloud2 message;
  message.header = header;
  message.width = width;
  message.height = height;
  for (const FieldName& field_name : names) {
    PointField field;
    field.name = field_name.name;
    field.datatype = field_name.datatype;
    field.offset = kNumberBytes * static_cast<std::uint32_t>(message.fields.size());
    field.count = 1;
    message.fields.push_back(field);
  }
  message.point_step = kNumberBytes * static_cast<std::uint32_t>(names.size());
  message.row_step = message.point_step * width;
  message.data.resize(std::size_t{message.row_step} * height);
  return message;
}

std::uint32_t packed(io::Rgb color) {
  return (std::uint32_t{color.red} << 16) | (std::uint32_t{color.green} << 8) | color.blue;
}

}  // namespace

PointCloud2 labelCloud(const std_msgs::Header& header, const Cloud& cloud, const std::vector<std::uint32_t>& labels,
                       const Detections& detections) {
  PointCloud2 message = makeCloud(header, cloud.width, cloud.height,
                                  {{"x", PointField::FLOAT32},
                                   {"y", PointField::FLOAT32},
                                   {"z", PointField::FLOAT32},
                                   {"rgb", PointField::FLOAT32},
                                   {"label", PointField::UINT32}});
  message.is_dense = cloud.valid_count == cloud.size();
  std::vector<std::uint32_t> colors;  // of each label
  for (const io::Rgb color : io::labelColors(detections)) colors.push_back(packed(color));
  std::uint8_t* out = message.data.data();
  for (std::size_t i = 0; i < cloud.size(); ++i, out += message.point_step) {
    const float position[3] = {cloud.x[i], cloud.y[i], cloud.z[i]};
    const std::uint32_t label = i < labels.size() && labels[i] < colors.size() ? labels[i] : 0;
    const std::uint32_t color_and_label[2] = {colors[label], label};
    std::memcpy(out, position, sizeof position);
    std::memcpy(out + sizeof position, color_and_label, sizeof color_and_label);
  }
  return message;
}

PointCloud2 normalCloud(const std_msgs::Header& header, const SampleView& samples) {
  PointCloud2 message = makeCloud(header, static_cast<std::uint32_t>(samples.count), 1,
                                  {{"x", PointField::FLOAT32},
                                   {"y", PointField::FLOAT32},
                                   {"z", PointField::FLOAT32},
                                   {"normal_x", PointField::FLOAT32},
                                   {"normal_y", PointField::FLOAT32},
                                   {"normal_z", PointField::FLOAT32}});
  message.is_dense = false;  // a sample may lack its normal
  std::uint8_t* out = message.data.data();
  for (std::size_t i = 0; i < samples.count; ++i, out += message.point_step) {
    const float values[6] = {samples.x[i], samples.y[i], samples.z[i], samples.nx[i], samples.ny[i], samples.nz[i]};
    std::memcpy(out, values, sizeof values);
  }
  return message;
}

}  // namespace primitect::ros_layer
