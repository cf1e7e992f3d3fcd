// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Adding up scores and printing them; see score_table.h.
#include "eval/score_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

namespace primitect::eval {
namespace {

constexpr double kCoverageEpsilon = 0.02;  // m
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double share(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : kNone; }

double median(std::vector<double> values) {
  if (values.empty()) return kNone;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// The cells of one line; NaN makes a dash.
struct Cells {
  double typed_precision = kNone, typed_recall = kNone;
  double precision = kNone, recall = kNone, missed = kNone, noise = kNone, over = kNone, under = kNone;
  double distance = kNone, typed_distance = kNone;
  double point_coverage = kNone, shape_coverage = kNone;
  double vote_ms = kNone, total_ms = kNone;
};

std::string cell(double value, int width, int decimals) {
  char text[32];
  if (std::isnan(value)) {
    std::snprintf(text, sizeof text, "%*s", width, "-");
  } else {
    std::snprintf(text, sizeof text, "%*.*f", width, decimals, value);
  }
  return text;
}

std::string format(const std::string& name, const Cells& cells) {
  char label[32];
  std::snprintf(label, sizeof label, "%-14.14s", name.c_str());
  std::string line = label;
  for (const double percent : {cells.typed_precision, cells.typed_recall, cells.precision, cells.recall, cells.missed,
                               cells.noise, cells.over, cells.under}) {
    line += cell(percent, 7, 1);
  }
  line += cell(cells.distance, 7, 2) + cell(cells.typed_distance, 7, 2);
  line += cell(cells.point_coverage, 7, 1) + cell(cells.shape_coverage, 7, 1);
  line += cell(cells.vote_ms, 8, 1) + cell(cells.total_ms, 8, 1);
  return line;
}

/// Precision, recall, missed, noise in percent, DOD in sigma: the paper's table of SegComp metrics.
using Published = std::array<double, 5>;

/// One entry a scene kind in the order of SceneKind; the paper has no table for scenes of planes alone.
const std::map<std::string, std::array<Published, synthetic::kSceneKindCount>>& published() {
  constexpr Published kNoScene = {kNone, kNone, kNone, kNone, kNone};
  const auto onlyDistance = [](double sigmas) { return Published{kNone, kNone, kNone, kNone, sigmas}; };
  static const std::map<std::string, std::array<Published, synthetic::kSceneKindCount>> kTable = {
      {"paper",
       {{{94.9, 91.3, 8.5, 0.3, 0.48},
         {95.9, 76.4, 23.3, 0.7, 0.60},
         {91.4, 54.1, 44.3, 1.9, 0.70},
         kNoScene,
         {74.7, 76.6, 21.7, 1.4, 0.56}}}},
      {"b",
       {{{85.1, 95.3, 2.9, 0.8, 1.32},
         {67.4, 65.1, 23.9, 6.1, 1.64},
         {64.3, 46.5, 45.8, 9.0, 1.54},
         kNoScene,
         {63.8, 57.7, 36.4, 7.3, 1.39}}}},
      {"c", {onlyDistance(1.15), onlyDistance(1.31), onlyDistance(1.24), kNoScene, onlyDistance(1.14)}},
      {"d", {onlyDistance(0.49), onlyDistance(0.65), onlyDistance(0.95), kNoScene, onlyDistance(0.59)}},
      {"e", {onlyDistance(0.58), onlyDistance(0.63), onlyDistance(0.75), kNoScene, onlyDistance(0.62)}}};
  return kTable;
}

}  // namespace

void addScene(Totals& totals, const synthetic::PaperScene& scene, const std::vector<Shape>& found, const Rules& rules) {
  const Assignment assignment = assign(scene.cloud, found, rules);
  const Overlaps overlaps = countOverlaps(scene.surface, scene.truth.size(), assignment.shape, found.size());
  const Segmentation untyped = segment(overlaps, rules.overlap);
  ++totals.scenes;
  totals.truths += static_cast<int>(scene.truth.size());
  totals.found += static_cast<int>(found.size());
  totals.correct += static_cast<int>(untyped.correct.size());
  totals.missed += untyped.missed;
  totals.noise += untyped.noise;
  totals.over_segmented += untyped.over_segmented;
  totals.under_segmented += untyped.under_segmented;
  for (const auto& [t, d] : untyped.correct) {
    const double away = objectDistance(scene.cloud, scene.surface, t, scene.truth[t], found[d]);
    const bool same_kind = kindOf(scene.truth[t]) == kindOf(found[d]);
    totals.distance_sum += away;
    totals.typed_distance_sum += same_kind ? away : 0.0;
    totals.typed_correct += same_kind ? 1 : 0;
  }
  totals.point_coverage += pointCoverage(assignment, scene.cloud, kCoverageEpsilon);
  totals.shape_coverage += shapeCoverage(assignment, scene.cloud, found, kCoverageEpsilon);
}

std::string tableHeading() {
  return "                  typed          |-------- any kind, % --------------------| DOD / sigma   coverage 0.02"
         "    median ms\n"
         "               prec.    rec.  prec.   rec. missed  noise   over  under    any  typed      p      s"
         "    vote   total";
}

std::string tableLine(const std::string& name, const Totals& totals, double sigma) {
  Cells cells;
  cells.typed_precision = share(totals.typed_correct, totals.found);
  cells.typed_recall = share(totals.typed_correct, totals.truths);
  cells.precision = share(totals.correct, totals.found);
  cells.recall = share(totals.correct, totals.truths);
  cells.missed = share(totals.missed, totals.truths);
  cells.noise = share(totals.noise, totals.found);
  cells.over = share(totals.over_segmented, totals.truths);
  cells.under = share(totals.under_segmented, totals.found);
  if (sigma > 0.0 && totals.correct > 0) cells.distance = totals.distance_sum / totals.correct / sigma;
  if (sigma > 0.0 && totals.typed_correct > 0) {
    cells.typed_distance = totals.typed_distance_sum / totals.typed_correct / sigma;
  }
  cells.point_coverage = share(totals.point_coverage, totals.scenes);
  cells.shape_coverage = share(totals.shape_coverage, totals.scenes);
  cells.vote_ms = median(totals.vote_ms);
  cells.total_ms = median(totals.total_ms);
  return format(name, cells);
}

std::string publishedLine(const std::string& config, synthetic::SceneKind kind) {
  const auto entry = published().find(config);
  if (entry == published().end()) return {};
  const Published& figures = entry->second[static_cast<std::size_t>(kind)];
  if (std::isnan(figures[4])) return {};
  Cells cells;
  cells.precision = figures[0];
  cells.recall = figures[1];
  cells.missed = figures[2];
  cells.noise = figures[3];
  cells.distance = figures[4];
  return format("  published", cells);
}

}  // namespace primitect::eval
