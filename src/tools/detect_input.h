// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From a file to what the detector gets.
#pragma once

#include <optional>
#include <string>

#include "io/point_files.h"
#include "primitect/cloud.h"
#include "primitect/moved_image.h"
#include "primitect/params.h"
#include "tools/detect_options.h"

namespace primitect::tools {

/// A file's points as they are, and as the detector gets them.
struct DetectInput {
  io::PointFile file;
  /// Where the user says that the sensor was, or the points tell it; else it is at the origin.
  std::optional<io::SensorPose> sensor;
  std::optional<CameraClue> found_by;  ///< what told sensor, where the points do
  bool sensor_at_origin = false;       ///< the same, of one that is there
  std::optional<Cloud> moved;          ///< with a sensor: all points, in its frame
  Params params;
  DepthRange range;
  Cloud cloud;  ///< in the frame of the sensor, cut to the range

  /// All points in the frame of the sensor.
  const Cloud& seen() const { return moved ? *moved : file.cloud; }
};

/// Throws as readPointFile() and ParamLayers::paramsFor().
DetectInput readInput(const DetectOptions& options, const std::string& path);

}  // namespace primitect::tools
