// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scores of one method summed over clouds, and the line of a table that they make.
#pragma once

#include <string>
#include <vector>

#include "eval/case_score.h"
#include "eval/methods.h"

namespace primitect::eval {

/// Sums over clouds; the shares of the table are those of the sums, not means of the clouds' shares.
struct Totals {
  Counts counts;
  int clouds = 0, failures = 0, false_curved = 0;
  double point_coverage = 0.0;  ///< sum of p(0.02)
  double shape_coverage = 0.0;  ///< sum of s(0.02) over the clouds that have one
  int shape_clouds = 0;
  std::vector<double> vote_ms, total_ms;  ///< one a cloud
};

void addCase(Totals& totals, const CaseScore& score, const Answer& answer);

/// The heading of the columns that tableLine() fills.
std::string tableHeading();

/// Percentages, DOD in the clouds' unit, false curved shapes a cloud, medians of the times; a dash where nothing is
/// known.
std::string tableLine(const std::string& name, const Totals& totals);

}  // namespace primitect::eval
