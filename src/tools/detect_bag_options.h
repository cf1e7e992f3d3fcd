// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The command line of `detect_bag`.
#pragma once

#include <optional>
#include <string>

#include "ros/bag_job.h"

namespace primitect::tools {

struct DetectBagOptions {
  ros_layer::BagJob job;
  std::string json;      ///< file, or "-"; empty: not wanted
  std::string pictures;  ///< folder; empty: not wanted
};

/// Nothing when all is said (--help, --version, --print-params).
/// Throws std::invalid_argument, one line, for whatever is wrong on the command line.
std::optional<DetectBagOptions> parseDetectBagOptions(int argc, char** argv);

}  // namespace primitect::tools
