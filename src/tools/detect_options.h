// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The command line of `detect`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/point_files.h"
#include "io/sensor_pose.h"
#include "tools/param_layers.h"

namespace primitect::tools {

struct DetectOptions {
  std::vector<std::string> files;
  std::string json, labels, picture;  ///< file or directory; empty: not wanted
  io::DepthImageOptions depth_image;
  std::optional<io::SensorPose> sensor;  ///< in the frame of the files; none: at its origin
  ParamLayers params;
  int repeats = 1;
  bool unlikely = false;  ///< what was not reported is wanted, too
  Steps left_out;
};

/// Nothing when all is said (--help, --version, --print-params, --kernels).
/// Throws std::invalid_argument, one line, for whatever is wrong on the command line.
std::optional<DetectOptions> parseDetectOptions(int argc, char** argv);

}  // namespace primitect::tools
