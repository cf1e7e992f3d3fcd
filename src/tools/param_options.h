// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Preset, parameter file and every parameter as options of a command line.
#pragma once

#include <map>
#include <set>
#include <string>

#include "tools/param_layers.h"

namespace CLI {
class App;
}

namespace primitect::tools {

class ParamOptions {
 public:
  /// Adds --preset, --params, --print-params and an option for each parameter that is none of these. This object must
  /// outlive the app's parsing.
  void addTo(CLI::App& app, const std::set<std::string>& without);

  /// What was said, after parsing. Throws std::invalid_argument naming file, parameter, value and range.
  void take(const CLI::App& app, ParamLayers& params) const;

  /// --print-params: print them all, and end.
  bool printWanted() const { return print_; }

 private:
  /// Raw texts, checked after parsing so that the messages name parameter, value and range.
  std::string preset_, file_;
  std::map<std::string, std::string> values_;
  bool print_ = false;
};

/// The parameters of this group of the table.
std::set<std::string> paramsOfGroup(const std::string& group);

}  // namespace primitect::tools
