// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The table of steps; see steps.h.
#include "primitect/steps.h"

#include <algorithm>
#include <stdexcept>

#include "core/similar_name.h"

namespace primitect {

const std::vector<StepInfo>& stepTable() {
  static const std::vector<StepInfo> kTable = {
#define PRIMITECT_STEP(name, stage, meaning) {Step::name, #name, stage, meaning},
#include "primitect/steps.def"
#undef PRIMITECT_STEP
  };
  return kTable;
}

Step stepOf(const std::string& name) {
  const std::vector<StepInfo>& table = stepTable();
  const auto found =
      std::find_if(table.begin(), table.end(), [&name](const StepInfo& row) { return row.name == name; });
  if (found != table.end()) return found->step;
  std::vector<std::string> names;
  for (const StepInfo& row : table) names.push_back(row.name);
  throw std::invalid_argument("unknown step '" + name + "'" + similarNameHint(name, names));
}

std::vector<std::string> namesOf(const Steps& steps) {
  std::vector<std::string> names;
  for (const StepInfo& row : stepTable()) {
    if (steps.has(row.step)) names.push_back(row.name);
  }
  return names;
}

}  // namespace primitect
