// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A PointCloud2 of any layout becomes a Cloud, or a text that says what is wrong with it.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <string>

#include "primitect/cloud.h"

namespace primitect::ros_layer {

/// More points than this are refused: far above any depth camera, below what could exhaust the memory.
constexpr std::uint64_t kMaxPoints = std::uint64_t{1} << 24;

/// What a cloud is read for.
struct Wanted {
  bool normals;  ///< normal_x, normal_y, normal_z, where the message brings them
  /// False: of a large image only every so many-th column and row, as many as are worked on (image_step.h).
  bool all_points;
};

/// Fills the cloud: (0, 0, 0), anything not finite and depths outside the range become missing.
/// Needs x, y, z as float32 or float64, little-endian. A message without points gives an empty cloud.
/// Returns an empty text, or what is wrong and what was expected; the cloud is then empty. Trusts no size in the
/// message.
std::string readCloud(const sensor_msgs::PointCloud2& message, const DepthRange& range, const Wanted& wanted,
                      Cloud& cloud);

}  // namespace primitect::ros_layer
