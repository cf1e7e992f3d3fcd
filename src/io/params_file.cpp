// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// yaml-cpp nodes to checked parameter values.
#include "io/params_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "io/file_checks.h"

namespace primitect::io {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& cause) {
  std::string line = path + ": " + cause;
  std::replace(line.begin(), line.end(), '\n', ' ');
  throw std::invalid_argument(line);
}

YAML::Node parseYaml(const std::string& path) {
  try {
    return YAML::LoadFile(path);
  } catch (const YAML::BadFile&) {
    refuse(path, "cannot be read");
  } catch (const std::exception& error) {
    refuse(path, std::string("is not YAML: ") + error.what());
  }
}

/// A plain scalar is what YAML takes it for, as on the ROS parameter server; a quoted one is always text.
ParamValue scalarValue(const YAML::Node& node) {
  if (node.Tag() == "!") return node.Scalar();
  bool truth = false;
  int whole = 0;
  double real = 0.0;
  if (YAML::convert<int>::decode(node, whole)) return whole;
  if (YAML::convert<double>::decode(node, real)) return real;
  if (YAML::convert<bool>::decode(node, truth)) return truth;
  return node.Scalar();
}

void readEntry(const std::string& name, const YAML::Node& node, ParamsFile& file) {
  if (name == "preset") {
    file.preset = node.IsScalar() ? node.Scalar() : "";
    presetParams(file.preset);
    return;
  }
  if (node.IsMap()) {
    throw std::invalid_argument("'" + name + "' has names below it, expected lines 'parameter: value' without it");
  }
  const ParamInfo& info = paramInfo(name);
  if (!node.IsScalar()) {
    throw std::invalid_argument("parameter '" + name + "' is " + (node.IsNull() ? "empty" : "a list") +
                                ", allowed: " + rangeText(info));
  }
  const ParamValue value = scalarValue(node);
  Params scratch;
  setParam(scratch, name, value);
  file.values.emplace_back(name, value);
}

}  // namespace

ParamsFile readParamsFile(const std::string& path) {
  ParamsFile file;
  try {
    if (readFileHead(path).bytes.find('\0') != std::string::npos) refuse(path, "is not YAML: it is a binary file");
  } catch (const FileError& error) {
    const bool empty = std::string(error.what()).find("is empty") != std::string::npos;
    if (empty) return file;
    throw std::invalid_argument(error.what());
  }
  const YAML::Node root = parseYaml(path);
  if (root.IsNull()) return file;
  if (!root.IsMap()) refuse(path, "expected lines 'parameter: value'");
  std::set<std::string> seen;
  std::string faults;
  for (const auto& entry : root) {
    try {
      if (!entry.first.IsScalar()) throw std::invalid_argument("a key is not a name");
      const std::string name = entry.first.Scalar();
      if (!seen.insert(name).second) throw std::invalid_argument(name + ": given twice");
      readEntry(name, entry.second, file);
    } catch (const std::invalid_argument& error) {
      faults += (faults.empty() ? "" : "; and: ") + std::string(error.what());
    }
  }
  if (!faults.empty()) refuse(path, faults);
  return file;
}

Params loadParams(const std::string& path) {
  const ParamsFile file = readParamsFile(path);
  Params params = presetParams(file.preset.empty() ? "default" : file.preset);
  for (const auto& [name, value] : file.values) setParam(params, name, value);
  try {
    checkParams(params);
  } catch (const std::invalid_argument& error) {
    refuse(path, error.what());
  }
  return params;
}

}  // namespace primitect::io
