// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The detector's parameters between the parameter server, dynamic_reconfigure and the core.
#pragma once

#include <primitect/DetectorConfig.h>
#include <ros/node_handle.h>

#include <map>
#include <string>
#include <vector>

#include "primitect/params.h"

namespace primitect::ros_layer {

/// All that stands under a node's private names; a name below a name is "outer/inner".
/// Throws std::invalid_argument naming the parameter when a value is neither bool, int, double nor string.
std::map<std::string, ParamValue> privateParameters(const ros::NodeHandle& private_handle);

/// True for private names that ROS libraries read, not this package.
bool isNodeName(const std::string& name);

struct LoadedParams {
  std::string preset = "default";
  Params params;
};

/// The preset first, then the explicit values on top of it.
/// Throws std::invalid_argument naming of all that is wrong parameter, value and range: unknown name, wrong type, out
/// of range.
LoadedParams loadParams(const std::map<std::string, ParamValue>& values);

/// "max_depth: 3.0, samples: 4096": what differs from the preset; "none" if nothing does.
std::string differenceText(const LoadedParams& loaded);

/// The same of these parameters from others.
std::string differenceText(const Params& params, const Params& from);

/// Writes every live parameter to the parameter server, where dynamic_reconfigure takes its first values from.
void writeParams(const ros::NodeHandle& private_handle, const Params& params);

/// Overwrites the values of config, not the state of its groups.
void copyToConfig(const Params& params, DetectorConfig& config);

/// The live parameters of config, the others of base, checked.
/// Throws std::invalid_argument naming parameter, value and range.
Params fromConfig(const DetectorConfig& config, const Params& base);

/// A table of another node's parameters (name, default, range): the values on the server, or the defaults.
/// Throws std::invalid_argument as loadParams().
std::map<std::string, ParamValue> loadTable(const std::vector<ParamInfo>& table,
                                            const std::map<std::string, ParamValue>& values);

}  // namespace primitect::ros_layer
