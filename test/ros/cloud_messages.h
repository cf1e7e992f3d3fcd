// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// PointCloud2 messages of any layout for the tests.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace primitect::test {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

inline PointField makeField(const std::string& name, std::uint32_t offset, std::uint8_t datatype) {
  PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = datatype;
  field.count = 1;
  return field;
}

template <typename Number>
void put(PointCloud2& message, std::uint32_t row, std::uint32_t column, std::uint32_t offset, Number value) {
  std::memcpy(message.data.data() + row * message.row_step + column * message.point_step + offset, &value,
              sizeof value);
}

/// width x height points (column, row, 1 + column + row) / 10 m; fields at the given offsets, rows padded.
template <typename Number>
PointCloud2 gridCloud(std::uint32_t width, std::uint32_t height, std::array<std::uint32_t, 3> offsets,
                      std::uint32_t point_step, std::uint32_t row_padding) {
  PointCloud2 message;
  const std::uint8_t datatype = sizeof(Number) == 8 ? PointField::FLOAT64 : PointField::FLOAT32;
  message.header.frame_id = "camera";
  message.header.stamp = ros::Time(12, 34);
  message.width = width;
  message.height = height;
  message.point_step = point_step;
  message.row_step = point_step * width + row_padding;
  message.data.assign(message.row_step * height, 0xab);
  const char* const names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) message.fields.push_back(makeField(names[i], offsets[i], datatype));
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      put<Number>(message, row, column, offsets[0], Number(column) / 10);
      put<Number>(message, row, column, offsets[1], Number(row) / 10);
      put<Number>(message, row, column, offsets[2], Number(1 + column + row) / 10);
    }
  }
  return message;
}

/// The plain layout: x, y, z as float32, 12 bytes.
inline PointCloud2 plainCloud(std::uint32_t width = 4, std::uint32_t height = 3) {
  return gridCloud<float>(width, height, {0, 4, 8}, 12, 0);
}

}  // namespace primitect::test
