// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scores as JSON lines, for eval/run.
#pragma once

#include <string>

#include "eval/case_score.h"
#include "eval/methods.h"

namespace primitect::eval {

/// One JSON object without line break: recipe, method, times, counts, curves, errors and what became of each detection;
/// eval/measuring.md lists the keys.
std::string scoreLine(const LabelledCloud& input, const Method& method, const Answer& answer, const CaseScore& score);

/// Compiler, build type and the methods that there are, one JSON object.
std::string aboutJson();

}  // namespace primitect::eval
