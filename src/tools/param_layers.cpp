// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Preset < YAML file < options.
#include "tools/param_layers.h"

#include <algorithm>
#include <sstream>

#include "io/params_file.h"

namespace primitect::tools {

void ParamLayers::addFile(const std::string& yaml_path) {
  const io::ParamsFile file = io::readParamsFile(yaml_path);
  if (!file.preset.empty()) preset_ = file.preset;
  values_.insert(values_.end(), file.values.begin(), file.values.end());
}

void ParamLayers::setPreset(const std::string& preset) {
  presetParams(preset);
  preset_ = preset;
}

void ParamLayers::addText(const std::string& name, const std::string& text) {
  Params scratch;
  setParamFromText(scratch, name, text);
  values_.emplace_back(name, getParam(scratch, name));
}

Params ParamLayers::paramsFor(bool camera_image, bool brings_normals) const {
  Params params = presetParams(preset_);
  if (!camera_image) params.min_depth = params.max_depth = 0.0;
  if (brings_normals) params.orient_normals = false;
  for (const auto& [name, value] : values_) setParam(params, name, value);
  checkParams(params);
  return params;
}

Params ParamLayers::asSaid() const {
  Params params = presetParams(preset_);
  for (const auto& [name, value] : values_) setParam(params, name, value);
  return params;
}

std::string ParamLayers::asYaml() const {
  std::ostringstream yaml;
  yaml << paramsAsYaml(preset_);
  if (values_.empty()) return yaml.str();
  const Params params = asSaid();
  yaml << "\n# Set explicitly\n";
  for (const ParamInfo& info : paramTable()) {
    const auto same_name = [&](const auto& value) { return value.first == info.name; };
    const bool set = std::any_of(values_.begin(), values_.end(), same_name);
    if (set) yaml << info.name << ": " << valueText(getParam(params, info.name)) << "\n";
  }
  return yaml.str();
}

}  // namespace primitect::tools
