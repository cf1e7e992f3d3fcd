// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Steps that the detector can be asked to leave out, to learn what each brings.
#pragma once

#include <bitset>
#include <cstddef>
#include <string>
#include <vector>

namespace primitect {

/// In the order of a frame; what each does: steps.def, or stepTable().
enum class Step {
#define PRIMITECT_STEP(name, stage, meaning) name,
#include "primitect/steps.def"
#undef PRIMITECT_STEP
};

/// One row of the table.
struct StepInfo {
  Step step;
  std::string name;
  std::string stage;  ///< of the frame, as Detector::onStageDone() names it
  std::string meaning;
};

/// All steps in the order of steps.def.
const std::vector<StepInfo>& stepTable();

/// The step of that name; throws std::invalid_argument naming it, and the one that is spelled nearly so, when there is
/// none.
Step stepOf(const std::string& name);

/// Some of the steps.
class Steps {
 public:
  bool has(Step step) const { return bits_[static_cast<std::size_t>(step)]; }
  void add(Step step) { bits_.set(static_cast<std::size_t>(step)); }

 private:
  static constexpr std::size_t kCount = 0
#define PRIMITECT_STEP(name, stage, meaning) +1
#include "primitect/steps.def"
#undef PRIMITECT_STEP
      ;
  std::bitset<kCount> bits_;
};

/// In the order of steps.def.
std::vector<std::string> namesOf(const Steps& steps);

}  // namespace primitect
