// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The parameter table made from params.def, checks with their messages, and the presets.
#include "primitect/params.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

#include "core/similar_name.h"

namespace primitect {
namespace {

using Setting = std::pair<const char*, ParamValue>;
using Setter = std::function<void(Params&, const ParamValue&)>;
using Getter = std::function<ParamValue(const Params&)>;

struct Entry {
  ParamInfo info;
  Getter get;
  Setter set;
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

template <class T>
Entry makeEntry(ParamInfo info, T Params::*member) {
  return {std::move(info), [member](const Params& params) { return ParamValue(params.*member); },
          [member](Params& params, const ParamValue& value) { params.*member = std::get<T>(value); }};
}

std::vector<Entry> makeEntries() {
  std::vector<Entry> entries;
  std::string group;
  using Text = std::string;
#define PRIMITECT_GROUP(name, meaning) group = #name;
#define PRIMITECT_CHOICE(name, value, choices, meaning) \
  entries.push_back(makeEntry({#name, group, Text(value), 0.0, 0.0, split(choices, '|'), "", meaning}, &Params::name));
#define PRIMITECT_BOOL(name, value, meaning) \
  entries.push_back(makeEntry({#name, group, bool(value), 0.0, 0.0, {}, "", meaning}, &Params::name));
#define PRIMITECT_INT(name, value, min, max, unit, meaning) \
  entries.push_back(makeEntry({#name, group, int(value), min, max, {}, unit, meaning}, &Params::name));
#define PRIMITECT_REAL(name, value, min, max, unit, meaning) \
  entries.push_back(makeEntry({#name, group, double(value), min, max, {}, unit, meaning}, &Params::name));
#define PRIMITECT_TEXT(name, value, meaning) \
  entries.push_back(makeEntry({#name, group, Text(value), 0.0, 0.0, {}, "", meaning}, &Params::name));
#include "primitect/params.def"
#undef PRIMITECT_GROUP
#undef PRIMITECT_CHOICE
#undef PRIMITECT_BOOL
#undef PRIMITECT_INT
#undef PRIMITECT_REAL
#undef PRIMITECT_TEXT
  return entries;
}

std::map<std::string, std::string> makeGroupMeanings() {
  std::map<std::string, std::string> meanings;
#define PRIMITECT_GROUP(name, meaning) meanings[#name] = meaning;
#define PRIMITECT_CHOICE(name, value, choices, meaning)
#define PRIMITECT_BOOL(name, value, meaning)
#define PRIMITECT_INT(name, value, min, max, unit, meaning)
#define PRIMITECT_REAL(name, value, min, max, unit, meaning)
#define PRIMITECT_TEXT(name, value, meaning)
#include "primitect/params.def"
#undef PRIMITECT_GROUP
#undef PRIMITECT_CHOICE
#undef PRIMITECT_BOOL
#undef PRIMITECT_INT
#undef PRIMITECT_REAL
#undef PRIMITECT_TEXT
  return meanings;
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> kEntries = makeEntries();
  return kEntries;
}

/// beside: another name that may be meant; that one itself is none of a parameter.
[[noreturn]] void refuseUnknown(const std::string& name, const std::vector<ParamInfo>& table,
                                const std::string& beside = "") {
  std::vector<std::string> names = {beside};
  for (const ParamInfo& info : table) names.push_back(info.name);
  throw std::invalid_argument("unknown parameter '" + name + "'" +
                              (name == beside ? "" : similarNameHint(name, names)));
}

const Entry& entryOf(const std::string& name) {
  const auto found =
      std::find_if(entries().begin(), entries().end(), [&name](const Entry& entry) { return entry.info.name == name; });
  if (found == entries().end()) refuseUnknown(name, paramTable(), "preset");
  return *found;
}

/// The preset "paper" is section "Choice of parameters" of the paper.
const std::map<std::string, std::vector<Setting>>& presets() {
  static const std::vector<Setting> kPaper = {
      {"rounds", 1},
      {"samples", 2048},
      {"references", 2048},
      {"pair_distance", 0.2},
      {"radius_bin", 0.005},
      {"radius_bins", 40},
      {"angle_bin_deg", 10.0},
      {"epsilon_deg", 10.0},
      {"convex_planes", true},
      {"spread_votes", true},
      {"average_bins", true},
      {"min_votes", 8.0},
      {"clustering", std::string("average")},
      {"cluster_distance", 0.01},
      {"cluster_angle_deg", 20.0},
      // Not in the paper: normals, and what is too weak to report. 20 of 2048 samples are half of its smallest objects.
      {"closer_samples", 0},
      {"max_latency", 0.0},
      {"seed", 1},
      {"normal_window", 7},
      {"improve_normals", false},
      {"normal_neighbors", 41},
      {"improve_normals", false},
      {"detect_planes", true},
      {"detect_spheres", true},
      {"detect_cylinders", true},
      {"detect_cones", true},
      {"convexity", std::string("convex")},
      {"scene_diameter", 0.0},
      {"verify", false},
      {"inlier_distance", 0.005},
      {"inlier_depth_share", 0.0},
      {"inlier_angle_deg", 20.0},
      {"min_inliers", 20},
      {"min_confidence", 0.0},
      {"min_radius", 0.0},
      {"max_radius", 0.0},
      {"min_half_angle_deg", 0.0},
      {"max_half_angle_deg", 90.0},
  };
  static const std::vector<Setting> kDrost = [] {
    std::vector<Setting> settings = kPaper;
    settings.insert(settings.end(),
                    {{"spread_votes", false}, {"average_bins", false}, {"clustering", std::string("nms")}});
    return settings;
  }();
  static const std::map<std::string, std::vector<Setting>> kPresets = {
      {"default", {}}, {"paper", kPaper}, {"drost", kDrost}};
  return kPresets;
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

const char* typeText(const ParamInfo& info) {
  constexpr const char* kTexts[] = {"true or false", "a whole number", "a number", "a text"};
  return kTexts[info.default_value.index()];
}

[[noreturn]] void refuse(const ParamInfo& info, const std::string& value) {
  throw std::invalid_argument("parameter '" + info.name + "' is " + value + ", allowed: " + rangeText(info));
}

/// The value in the parameter's own type; throws when it has another one.
ParamValue converted(const ParamInfo& info, const ParamValue& value) {
  if (value.index() == info.default_value.index()) return value;
  if (std::holds_alternative<double>(info.default_value) && std::holds_alternative<int>(value)) {
    return static_cast<double>(std::get<int>(value));
  }
  refuse(info, valueText(value));
}

bool inRange(const ParamInfo& info, const ParamValue& value) {
  if (const int* number = std::get_if<int>(&value)) return info.min <= *number && *number <= info.max;
  if (const double* number = std::get_if<double>(&value)) return info.min <= *number && *number <= info.max;
  const std::string* text = std::get_if<std::string>(&value);
  if (!text || info.choices.empty()) return true;
  return std::find(info.choices.begin(), info.choices.end(), *text) != info.choices.end();
}

std::string numberText(double number) {
  std::ostringstream stream;
  stream.precision(12);
  stream << number;
  return stream.str();
}

}  // namespace

const std::vector<ParamInfo>& paramTable() {
  static const std::vector<ParamInfo> kTable = [] {
    std::vector<ParamInfo> table;
    for (const Entry& entry : entries()) table.push_back(entry.info);
    return table;
  }();
  return kTable;
}

const ParamInfo& rowOf(const std::vector<ParamInfo>& table, const std::string& name) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&name](const ParamInfo& info) { return info.name == name; });
  if (found == table.end()) refuseUnknown(name, table);
  return *found;
}

const ParamInfo& paramInfo(const std::string& name) { return entryOf(name).info; }

ParamValue getParam(const Params& params, const std::string& name) { return entryOf(name).get(params); }

ParamValue checkedValue(const ParamInfo& info, const ParamValue& value) {
  const ParamValue own = converted(info, value);
  if (!inRange(info, own)) refuse(info, valueText(own));
  return own;
}

void setParam(Params& params, const std::string& name, const ParamValue& value) {
  const Entry& entry = entryOf(name);
  entry.set(params, checkedValue(entry.info, value));
}

void setParamFromText(Params& params, const std::string& name, const std::string& text) {
  const ParamInfo& info = paramInfo(name);
  if (std::holds_alternative<std::string>(info.default_value)) return setParam(params, name, text);
  if (std::holds_alternative<bool>(info.default_value)) {
    if (text == "true" || text == "1") return setParam(params, name, true);
    if (text == "false" || text == "0") return setParam(params, name, false);
    refuse(info, "'" + text + "'");
  }
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool whole = std::holds_alternative<int>(info.default_value);
  if (text.empty() || *end != '\0' || !(info.min <= number && number <= info.max)) refuse(info, "'" + text + "'");
  if (whole && number != std::floor(number)) refuse(info, "'" + text + "'");
  if (whole) return setParam(params, name, static_cast<int>(number));
  setParam(params, name, number);
}

std::string rangeText(const ParamInfo& info) {
  if (!info.choices.empty()) return joined(info.choices, " or ");
  const bool number =
      std::holds_alternative<int>(info.default_value) || std::holds_alternative<double>(info.default_value);
  if (!number) return typeText(info);
  const std::string unit = info.unit.empty() ? "" : " " + info.unit;
  return std::string(typeText(info)) + " from " + numberText(info.min) + " to " + numberText(info.max) + unit;
}

std::string valueText(const ParamValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const int* number = std::get_if<int>(&value)) return std::to_string(*number);
  if (const std::string* text = std::get_if<std::string>(&value)) return "'" + *text + "'";
  const std::string text = numberText(std::get<double>(value));
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

void checkParams(const Params& params) {
  for (const Entry& entry : entries()) {
    const ParamValue value = entry.get(params);
    if (!inRange(entry.info, value)) refuse(entry.info, valueText(value));
  }
  const auto refuseOrder = [&params](const char* low, const char* high) {
    throw std::invalid_argument(std::string("parameter '") + low + "' is " + valueText(getParam(params, low)) +
                                ", allowed: less than '" + high + "', which is " + valueText(getParam(params, high)));
  };
  if (params.max_depth > 0.0 && params.min_depth >= params.max_depth) refuseOrder("min_depth", "max_depth");
  if (params.max_radius > 0.0 && params.min_radius >= params.max_radius) refuseOrder("min_radius", "max_radius");
  if (params.min_half_angle_deg >= params.max_half_angle_deg) refuseOrder("min_half_angle_deg", "max_half_angle_deg");
}

std::vector<std::string> presetNames() {
  std::vector<std::string> names;
  for (const auto& preset : presets()) names.push_back(preset.first);
  return names;
}

Params presetParams(const std::string& preset) {
  const auto found = presets().find(preset);
  if (found == presets().end()) {
    throw std::invalid_argument("parameter 'preset' is '" + preset + "', allowed: " + joined(presetNames(), " or "));
  }
  Params params;
  for (const Setting& setting : found->second) setParam(params, setting.first, setting.second);
  return params;
}

std::vector<std::string> presetSettings(const std::string& preset) {
  std::vector<std::string> names;
  const auto found = presets().find(preset);
  if (found == presets().end()) presetParams(preset);  // throws
  for (const Setting& setting : found->second) names.push_back(setting.first);
  return names;
}

std::string paramsAsYaml(const std::string& preset) {
  const Params params = presetParams(preset);
  const std::map<std::string, std::string> meanings = makeGroupMeanings();
  std::ostringstream yaml;
  yaml << "# All parameters of primitect with the values of this preset. A preset sets them all; remove the # before\n"
       << "# a line and change its value to override one. Unknown names and values out of range are refused.\n\n"
       << "preset: " << preset << "  # " << joined(presetNames(), " or ") << "\n";
  std::string group;
  for (const ParamInfo& info : paramTable()) {
    if (info.group != group) yaml << "\n# " << meanings.at(info.group) << "\n";
    group = info.group;
    yaml << "# " << info.name << ": " << valueText(getParam(params, info.name)) << "  # " << rangeText(info) << ": "
         << info.meaning << "\n";
  }
  return yaml.str();
}

}  // namespace primitect
