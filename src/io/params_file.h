// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// YAML files of parameters.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "primitect/params.h"

namespace primitect::io {

/// What a file says, in its order; nothing that it does not say.
struct ParamsFile {
  std::string preset;  ///< empty: none named
  std::vector<std::pair<std::string, ParamValue>> values;
};

/// Reads a flat map: `preset` and any parameter of paramTable(). A file that is empty or all comments says nothing.
/// Every entry is checked. Throws std::invalid_argument, one line naming the file and of all that is wrong parameter,
/// value and range: unknown or repeated key, wrong type, out of range, unknown preset; and naming file and cause when
/// it is no such YAML.
ParamsFile readParamsFile(const std::string& path);

/// The preset (or the default one) with the file's values on top; checked as a whole. Throws as readParamsFile().
Params loadParams(const std::string& path);

}  // namespace primitect::io
