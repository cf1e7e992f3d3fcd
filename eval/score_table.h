// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scores of one method summed over scenes, and the line of a table that they make.
#pragma once

#include <string>
#include <vector>

#include "eval/metrics.h"
#include "synthetic/paper_dataset.h"

namespace primitect::eval {

/// Sums over scenes; the shares of the table are those of the sums, not means of the scenes' shares.
struct Totals {
  int truths = 0, found = 0;
  int correct = 0, missed = 0, noise = 0, over_segmented = 0, under_segmented = 0;
  int typed_correct = 0;
  double distance_sum = 0.0;        ///< DOD of all correct pairs, m
  double typed_distance_sum = 0.0;  ///< of those with the right kind only, m
  int scenes = 0;
  double point_coverage = 0.0;  ///< sums of p(0.02) and s(0.02)
  double shape_coverage = 0.0;
  std::vector<double> vote_ms, total_ms;  ///< one a scene
};

/// Scores the shapes found in a scene and adds them up.
void addScene(Totals& totals, const synthetic::PaperScene& scene, const std::vector<Shape>& found, const Rules& rules);

/// The heading of the columns that tableLine() fills.
std::string tableHeading();

/// Percentages, DOD in sigma (m; without noise a dash), medians of the times.
std::string tableLine(const std::string& name, const Totals& totals, double sigma);

/// The paper's own figures at sigma = 0.01 for "paper" (its "ours") and its ablations "b" to "e", in the same columns;
/// empty where the paper has none.
std::string publishedLine(const std::string& config, synthetic::SceneKind kind);

}  // namespace primitect::eval
