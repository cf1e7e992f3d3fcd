// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Read, moved to the sensor, cut.
#include "tools/detect_input.h"

#include "primitect/moved_image.h"

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

/// What a node does with a cloud that was moved to another frame.
void moveToFoundCamera(DetectInput& input) {
  const std::optional<CameraSearch> in_cut = searchForCameraInCut(input.cloud);
  const CameraSearch found = in_cut ? *in_cut : searchForCamera(input.file.cloud);
  input.sensor_at_origin = found.at_origin;
  if (!found.cloud_from_camera) return;
  input.sensor = io::SensorPose::of(*found.cloud_from_camera);
  input.found_by = found.clue;
  moveToSensor(*input.sensor, input);
}

}  // namespace

DetectInput readInput(const DetectOptions& options, const std::string& path) {
  DetectInput input;
  input.file = io::readPointFile(path, options.depth_image);
  input.sensor = options.sensor;
  const Cloud& points = input.file.cloud;
  input.params = options.params.paramsFor(points.organized() || input.file.intrinsics, points.hasNormals());
  input.params.left_out = options.left_out;
  // As the node, which does not even read them: they say nothing of where the camera was.
  if (!input.params.use_cloud_normals) input.file.cloud.dropNormals();
  input.range = depthRangeOf(input.params);
  if (input.sensor) {
    moveToSensor(*input.sensor, input);
  } else {
    io::cutAtDepth(points, input.range, input.cloud);
    moveToFoundCamera(input);
  }
  return input;
}

}  // namespace primitect::tools
