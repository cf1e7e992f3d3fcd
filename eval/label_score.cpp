// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Counting points; see label_score.h.
#include "eval/label_score.h"

#include <algorithm>
#include <stdexcept>

namespace primitect::eval {
namespace {

LabelScore countPoints(const LabelledCloud& input, const std::vector<std::uint32_t>& labels, std::uint32_t label,
                       int true_shape) {
  LabelScore counts;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!input.cloud.valid(i)) continue;
    const bool labelled = labels[i] == label, on_shape = input.surface[i] == true_shape;
    counts.labelled += labelled;
    counts.on_shape += on_shape;
    counts.both += labelled && on_shape;
  }
  return counts;
}

}  // namespace

std::vector<std::optional<LabelScore>> scoreLabels(const LabelledCloud& input, const std::vector<std::uint32_t>& labels,
                                                   const CaseScore& score) {
  if (labels.size() != input.cloud.size()) {
    throw std::invalid_argument("scoring: labels and points differ in number");
  }
  std::vector<std::optional<LabelScore>> scores(score.verdicts.size());
  if (!isPointByPoint(input)) return scores;
  for (std::size_t d = 0; d < scores.size(); ++d) {
    const int t = score.true_shape[d];
    if (t == kNoShape || !input.truth[t].exact) continue;
    if (std::count(score.true_shape.begin(), score.true_shape.end(), t) > 1) continue;
    scores[d] = countPoints(input, labels, static_cast<std::uint32_t>(d + 1), t);
  }
  return scores;
}

}  // namespace primitect::eval
