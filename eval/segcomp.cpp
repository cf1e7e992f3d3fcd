// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// SegComp and the accuracy of the kinds; see segcomp.h.
#include "eval/segcomp.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace primitect::eval {
namespace {

/// What is known of true regions or detections while instances are looked for.
struct Regions {
  const std::vector<int>& sizes;
  std::vector<bool> correct;
  std::vector<bool> explained;  ///< in any instance

  explicit Regions(const std::vector<int>& point_counts)
      : sizes(point_counts), correct(point_counts.size()), explained(point_counts.size()) {}
};

/// Finds the wholes that two or more parts make up, each part lying to the given share within the whole and all
/// together covering that share of it. Returns those of these wholes that are not correct. common: points of (whole,
/// part).
template <typename Common>
std::vector<int> explainSplits(Regions& wholes, Regions& parts, Common common, double share) {
  std::vector<int> splits;
  for (std::size_t whole = 0; whole < wholes.sizes.size(); ++whole) {
    std::vector<std::size_t> inside;
    int covered = 0;
    for (std::size_t part = 0; part < parts.sizes.size(); ++part) {
      const int points = common(whole, part);
      if (points == 0 || points < share * parts.sizes[part]) continue;
      inside.push_back(part);
      covered += points;
    }
    if (inside.size() < 2 || covered < share * wholes.sizes[whole]) continue;
    if (!wholes.correct[whole]) splits.push_back(static_cast<int>(whole));
    wholes.explained[whole] = true;
    for (const std::size_t part : inside) parts.explained[part] = true;
  }
  return splits;
}

std::vector<int> indicesOfFalse(const std::vector<bool>& flags) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (!flags[i]) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

}  // namespace

Overlaps::Overlaps(std::size_t truths, std::size_t detections)
    : true_size(truths, 0), found_size(detections, 0), common(truths, std::vector<int>(detections, 0)) {}

Overlaps countOverlaps(const std::vector<int>& truth, std::size_t truths, const std::vector<int>& found,
                       std::size_t detections) {
  if (truth.size() != found.size()) throw std::invalid_argument("scoring: truth and result differ in their points");
  Overlaps overlaps(truths, detections);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] >= 0) ++overlaps.true_size.at(truth[i]);
    if (found[i] >= 0) ++overlaps.found_size.at(found[i]);
    if (truth[i] >= 0 && found[i] >= 0) ++overlaps.common[truth[i]][found[i]];
  }
  return overlaps;
}

Segmentation segment(const Overlaps& overlaps, double overlap) {
  Segmentation result;
  Regions truths(overlaps.true_size), found(overlaps.found_size);
  for (std::size_t t = 0; t < truths.sizes.size(); ++t) {
    for (std::size_t d = 0; d < found.sizes.size(); ++d) {
      const int common = overlaps.common[t][d];
      if (common == 0 || common < overlap * truths.sizes[t] || common < overlap * found.sizes[d]) continue;
      result.correct.emplace_back(static_cast<int>(t), static_cast<int>(d));
      truths.correct[t] = truths.explained[t] = true;
      found.correct[d] = found.explained[d] = true;
    }
  }
  result.over_segmented = explainSplits(
      truths, found, [&](std::size_t t, std::size_t d) { return overlaps.common[t][d]; }, overlap);
  result.under_segmented = explainSplits(
      found, truths, [&](std::size_t d, std::size_t t) { return overlaps.common[t][d]; }, overlap);
  result.missed = indicesOfFalse(truths.explained);
  result.noise = indicesOfFalse(found.explained);
  return result;
}

std::vector<std::pair<int, int>> sameKindMatches(const Overlaps& overlaps, const std::vector<Kind>& true_kinds,
                                                 const std::vector<Kind>& found_kinds) {
  std::vector<std::tuple<double, int, int>> pairs;  // minus the overlap, so that the best sort first
  for (std::size_t t = 0; t < overlaps.true_size.size(); ++t) {
    for (std::size_t d = 0; d < overlaps.found_size.size(); ++d) {
      const double common = overlaps.common[t][d];
      if (common == 0.0) continue;
      const double together = overlaps.true_size[t] + overlaps.found_size[d] - common;
      pairs.emplace_back(-common / together, static_cast<int>(t), static_cast<int>(d));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> true_used(overlaps.true_size.size()), found_used(overlaps.found_size.size());
  std::vector<std::pair<int, int>> matches;
  for (const auto& [minus_overlap, t, d] : pairs) {
    if (true_used[t] || found_used[d]) continue;
    true_used[t] = found_used[d] = true;
    if (true_kinds.at(t) == found_kinds.at(d)) matches.emplace_back(t, d);
  }
  return matches;
}

}  // namespace primitect::eval
