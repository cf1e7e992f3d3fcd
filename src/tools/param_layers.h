// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parameters in layers: a preset, what suits the file, and what the user said.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/params.h"

namespace primitect::tools {

/// The user's wishes, strongest last. Each value on its own is within its range.
class ParamLayers {
 public:
  /// The file may name a preset. Throws std::invalid_argument naming file, parameter, value and range.
  void addFile(const std::string& yaml_path);

  /// Replaces the preset that a file named. Throws std::invalid_argument for an unknown one.
  void setPreset(const std::string& preset);

  /// Throws std::invalid_argument naming parameter, value and range.
  void addText(const std::string& name, const std::string& text);

  /// A camera image is cut at the parameters' depths, any other cloud is not, and normals that a file brings are kept
  /// as they are, unless the user said otherwise. Throws std::invalid_argument when two parameters contradict each
  /// other.
  Params paramsFor(bool camera_image, bool brings_normals) const;

  /// The preset and what the user said, whatever the file is; not checked as a whole.
  Params asSaid() const;

  /// A YAML file that sets the same.
  std::string asYaml() const;

 private:
  std::string preset_ = "default";
  std::vector<std::pair<std::string, ParamValue>> values_;
};

}  // namespace primitect::tools
