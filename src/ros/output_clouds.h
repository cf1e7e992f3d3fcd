// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The clouds that go out: labels of all points, and the samples with their normals.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/detector.h"
#include "primitect/primitives.h"

namespace primitect::ros_layer {

/// x, y, z (float32, m), rgb (packed in a float32, one colour a kind, in shades), label (uint32: id + 1, 0 = none).
/// As wide and high as the cloud; missing points are NaN.
sensor_msgs::PointCloud2 labelCloud(const std_msgs::Header& header, const Cloud& cloud,
                                    const std::vector<std::uint32_t>& labels, const Detections& detections);

/// The samples that voted: x, y, z (m), normal_x, normal_y, normal_z, float32.
sensor_msgs::PointCloud2 normalCloud(const std_msgs::Header& header, const SampleView& samples);

}  // namespace primitect::ros_layer
