// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Strict: nothing unknown, of another type or out of range passes.
#include "parameters.h"

#include <XmlRpcValue.h>

#include <stdexcept>

namespace primitect::ros_layer {
namespace {

using Values = std::map<std::string, ParamValue>;

void flatten(const std::string& name, XmlRpc::XmlRpcValue& value, Values& values) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      values[name] = static_cast<bool>(value);
      return;
    case XmlRpc::XmlRpcValue::TypeInt:
      values[name] = static_cast<int>(value);
      return;
    case XmlRpc::XmlRpcValue::TypeDouble:
      values[name] = static_cast<double>(value);
      return;
    case XmlRpc::XmlRpcValue::TypeString:
      values[name] = static_cast<std::string>(value);
      return;
    case XmlRpc::XmlRpcValue::TypeStruct:
      for (auto& inner : value) flatten(name.empty() ? inner.first : name + "/" + inner.first, inner.second, values);
      return;
    default:
      throw std::invalid_argument("parameter '" + name + "' is " + value.toXml() +
                                  ", allowed: true or false, a number or a text");
  }
}

std::string presetOf(const Values& values) {
  const auto found = values.find("preset");
  if (found == values.end()) return "default";
  if (const std::string* preset = std::get_if<std::string>(&found->second)) return *preset;
  std::string known;
  for (const std::string& name : presetNames()) known += (known.empty() ? "" : " or ") + name;
  throw std::invalid_argument("parameter 'preset' is " + valueText(found->second) + ", allowed: " + known);
}

}  // namespace

std::map<std::string, ParamValue> privateParameters(const ros::NodeHandle& private_handle) {
  Values values;
  XmlRpc::XmlRpcValue tree;
  if (!private_handle.getParam(private_handle.getNamespace(), tree)) return values;
  if (tree.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
    throw std::invalid_argument("parameter '" + private_handle.getNamespace() +
                                "' is a single value, allowed: names below it");
  }
  flatten("", tree, values);
  return values;
}

bool isNodeName(const std::string& name) { return name == "num_worker_threads" || name == "diagnostic_period"; }

LoadedParams loadParams(const std::map<std::string, ParamValue>& values) {
  LoadedParams loaded;
  std::string faults;
  const auto collect = [&faults](const auto& take) {
    try {
      take();
    } catch (const std::invalid_argument& error) {
      faults += (faults.empty() ? "" : "; and: ") + std::string(error.what());
    }
  };
  collect([&] {
    loaded.preset = presetOf(values);
    loaded.params = presetParams(loaded.preset);
  });
  for (const auto& value : values) {
    if (value.first == "preset" || isNodeName(value.first)) continue;
    collect([&] { setParam(loaded.params, value.first, value.second); });
  }
  if (!faults.empty()) throw std::invalid_argument(faults);
  checkParams(loaded.params);
  return loaded;
}

std::string differenceText(const LoadedParams& loaded) {
  return differenceText(loaded.params, presetParams(loaded.preset));
}

std::string differenceText(const Params& params, const Params& from) {
  std::string text;
  for (const ParamInfo& info : paramTable()) {
    const ParamValue value = getParam(params, info.name);
    if (value == getParam(from, info.name)) continue;
    text += (text.empty() ? "" : ", ") + info.name + ": " + valueText(value);
  }
  return text.empty() ? "none" : text;
}

#define PRIMITECT_GROUP(name, meaning)
#define PRIMITECT_CHOICE(name, value, choices, meaning) PRIMITECT_LIVE(name)
#define PRIMITECT_BOOL(name, value, meaning) PRIMITECT_LIVE(name)
#define PRIMITECT_INT(name, value, min, max, unit, meaning) PRIMITECT_LIVE(name)
#define PRIMITECT_REAL(name, value, min, max, unit, meaning) PRIMITECT_LIVE(name)
#define PRIMITECT_TEXT(name, value, meaning)

void writeParams(const ros::NodeHandle& private_handle, const Params& params) {
#define PRIMITECT_LIVE(name) private_handle.setParam(#name, params.name);
#include "primitect/params.def"
#undef PRIMITECT_LIVE
}

void copyToConfig(const Params& params, DetectorConfig& config) {
#define PRIMITECT_LIVE(name) config.name = params.name;
#include "primitect/params.def"
#undef PRIMITECT_LIVE
}

Params fromConfig(const DetectorConfig& config, const Params& base) {
  Params params = base;
#define PRIMITECT_LIVE(name) params.name = config.name;
#include "primitect/params.def"
#undef PRIMITECT_LIVE
  checkParams(params);
  return params;
}

#undef PRIMITECT_GROUP
#undef PRIMITECT_CHOICE
#undef PRIMITECT_BOOL
#undef PRIMITECT_INT
#undef PRIMITECT_REAL
#undef PRIMITECT_TEXT

std::map<std::string, ParamValue> loadTable(const std::vector<ParamInfo>& table,
                                            const std::map<std::string, ParamValue>& values) {
  Values loaded;
  for (const ParamInfo& info : table) loaded[info.name] = info.default_value;
  for (const auto& [name, value] : values) {
    if (!isNodeName(name)) loaded[name] = checkedValue(rowOf(table, name), value);
  }
  return loaded;
}

}  // namespace primitect::ros_layer
