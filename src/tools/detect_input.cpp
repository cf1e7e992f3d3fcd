// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Read, moved to the sensor, cut.
#include "tools/detect_input.h"

namespace primitect::tools {
namespace {

/// What a node with sensor_frame does with its input.
void moveToSensor(const io::SensorPose& sensor, DetectInput& input) {
  const Eigen::Isometry3d sensor_from_points = sensor.pointsFromSensor().inverse();
  input.moved = input.file.cloud;
  input.moved->move(sensor_from_points, DepthRange());
  input.cloud = input.file.cloud;
  input.cloud.move(sensor_from_points, input.range);
}

}  // namespace

DetectInput readInput(const DetectOptions& options, const std::string& path) {
  DetectInput input;
  input.file = io::readPointFile(path, options.depth_image);
  input.sensor = options.sensor;
  const Cloud& points = input.file.cloud;
  input.params = options.params.paramsFor(points.organized() || input.file.intrinsics, points.hasNormals());
  input.range = {static_cast<float>(input.params.min_depth), static_cast<float>(input.params.max_depth)};
  if (input.sensor) {
    moveToSensor(*input.sensor, input);
  } else {
    io::cutAtDepth(points, input.range, input.cloud);
  }
  if (!input.params.use_cloud_normals) input.cloud.dropNormals();
  return input;
}

}  // namespace primitect::tools
