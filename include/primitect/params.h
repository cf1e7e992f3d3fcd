// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// All parameters of the detector: plain members, generated from params.def, and a table to read and set them by name.
#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "primitect/steps.h"

namespace primitect {

/// The parameters with their defaults. Name, range, unit and meaning: params.def, or paramTable().
struct Params {
#define PRIMITECT_GROUP(name, meaning)
#define PRIMITECT_CHOICE(name, default_value, choices, meaning) std::string name = default_value;
#define PRIMITECT_BOOL(name, default_value, meaning) bool name = default_value;
#define PRIMITECT_INT(name, default_value, min, max, unit, meaning) int name = default_value;
#define PRIMITECT_REAL(name, default_value, min, max, unit, meaning) double name = default_value;
#define PRIMITECT_TEXT(name, default_value, meaning) std::string name = default_value;
#include "primitect/params.def"
#undef PRIMITECT_GROUP
#undef PRIMITECT_CHOICE
#undef PRIMITECT_BOOL
#undef PRIMITECT_INT
#undef PRIMITECT_REAL
#undef PRIMITECT_TEXT

  /// Steps that are left out, for studies; not in the table of parameters.
  Steps left_out;
  bool does(Step step) const { return !left_out.has(step); }
};

using ParamValue = std::variant<bool, int, double, std::string>;

/// One row of the parameter table.
struct ParamInfo {
  std::string name;
  std::string group;
  ParamValue default_value;  ///< its alternative is the parameter's type
  double min = 0.0;          ///< int and double only, inclusive
  double max = 0.0;
  std::vector<std::string> choices;  ///< allowed texts; empty: any
  std::string unit;
  std::string meaning;
};

/// All parameters in the order of params.def.
const std::vector<ParamInfo>& paramTable();

/// The row of a table with that name. Throws std::invalid_argument when there is none, naming the parameter, and the
/// one that is spelled nearly so.
const ParamInfo& rowOf(const std::vector<ParamInfo>& table, const std::string& name);

/// The row of that name in paramTable(); throws as rowOf().
const ParamInfo& paramInfo(const std::string& name);

/// The value of that name; throws std::invalid_argument when there is none.
ParamValue getParam(const Params& params, const std::string& name);

/// The value in the type of the row. An int is taken where a double is expected; nothing else is converted.
/// Throws std::invalid_argument naming parameter, value and range: wrong type, out of range.
ParamValue checkedValue(const ParamInfo& info, const ParamValue& value);

/// Sets one value, as checkedValue() gives it. Throws std::invalid_argument as it does, and for an unknown name.
void setParam(Params& params, const std::string& name, const ParamValue& value);

/// Sets one value from text, as on a command line ("true", "12", "0.5", "nms"). Throws as setParam().
void setParamFromText(Params& params, const std::string& name, const std::string& text);

/// "0.1 to 100 m", "true or false", "average or nms", ...
std::string rangeText(const ParamInfo& info);
std::string valueText(const ParamValue& value);

/// Throws std::invalid_argument for the first parameter out of its range, or for a pair that contradicts itself.
void checkParams(const Params& params);

/// Names of the presets: "default", "paper", "drost".
std::vector<std::string> presetNames();

/// The parameters of a preset; throws std::invalid_argument naming it and the known ones when there is none.
/// Explicit values are set on top of it, in any order.
Params presetParams(const std::string& preset);

/// Names of the parameters that a preset sets itself, whatever the defaults are; throws as presetParams().
std::vector<std::string> presetSettings(const std::string& preset);

/// The whole table as a commented YAML file (the text of config/default.yaml for the preset "default").
std::string paramsAsYaml(const std::string& preset);

}  // namespace primitect
