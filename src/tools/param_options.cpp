// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The table of parameters as options.
#include "tools/param_options.h"

#include <CLI/CLI.hpp>

namespace primitect::tools {
namespace {

std::string presetList() {
  std::string list;
  for (const std::string& name : presetNames()) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

std::set<std::string> paramsOfGroup(const std::string& group) {
  std::set<std::string> names;
  for (const ParamInfo& info : paramTable()) {
    if (info.group == group) names.insert(info.name);
  }
  return names;
}

void ParamOptions::addTo(CLI::App& app, const std::set<std::string>& without) {
  app.add_option("--preset", preset_, "parameters to start from: " + presetList())->type_name("NAME");
  app.add_option("--params", file_, "YAML file with a preset and parameters")->type_name("YAML");
  app.add_flag("--print-params", print_, "print all parameters as a YAML file and end");
  const Params defaults = presetParams("default");
  for (const ParamInfo& info : paramTable()) {
    if (without.count(info.name) > 0) continue;
    app.add_option("--" + info.name, values_[info.name],
                   valueText(getParam(defaults, info.name)) + " (" + rangeText(info) + ")\n" + info.meaning)
        ->type_name(" ")
        ->group("Parameters: " + info.group);
  }
}

void ParamOptions::take(const CLI::App& app, ParamLayers& params) const {
  if (app.count("--params")) params.addFile(file_);
  if (app.count("--preset")) params.setPreset(preset_);
  for (const auto& [name, text] : values_) {
    if (app.count("--" + name)) params.addText(name, text);
  }
}

}  // namespace primitect::tools
