// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scoring one result; see case_score.h.
#include "eval/case_score.h"

#include <algorithm>

#include "eval/faces.h"
#include "eval/segcomp.h"

namespace primitect::eval {
namespace {

/// What counts of a cloud's truth and of a result, under new indices without gaps.
struct Scored {
  std::vector<int> truths, detections;  ///< the old index of each
  std::vector<int> true_label, found_label;
};

/// The old label of each point in its new numbering; -1 for what does not count.
std::vector<int> renumbered(const std::vector<int>& labels, const std::vector<int>& kept, std::size_t old_count) {
  std::vector<int> new_index(old_count, -1);
  for (std::size_t k = 0; k < kept.size(); ++k) new_index[kept[k]] = static_cast<int>(k);
  std::vector<int> result(labels.size(), -1);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] >= 0) result[i] = new_index[labels[i]];
  }
  return result;
}

std::vector<int> shapesThatMustBeFound(const std::vector<TrueShape>& truth) {
  std::vector<int> kept;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    if (truth[t].must) kept.push_back(static_cast<int>(t));
  }
  return kept;
}

/// Of each detection: its points on shapes that need not be found, and its other points. The former, and those on
/// clutter, lose their label.
std::vector<std::pair<int, int>> takeOptionalPoints(const LabelledCloud& input, std::size_t detections,
                                                    std::vector<int>& found_label) {
  std::vector<std::pair<int, int>> points(detections, {0, 0});
  for (std::size_t i = 0; i < found_label.size(); ++i) {
    const int t = input.surface[i], d = found_label[i];
    if (d < 0) continue;
    const bool is_optional = t >= 0 && !input.truth[t].must;
    ++(is_optional ? points[d].first : points[d].second);
    if (is_optional || t == kClutter) found_label[i] = kNoShape;
  }
  return points;
}

/// with: of joinedOnFaces(); what counts with another one does not count by itself.
Scored whatCounts(const LabelledCloud& input, const std::vector<int>& with, std::vector<int> found_label,
                  double overlap) {
  const std::size_t detections = with.size();
  for (int& d : found_label) d = d >= 0 ? with[d] : d;
  Scored scored;
  scored.truths = shapesThatMustBeFound(input.truth);
  scored.true_label = renumbered(input.surface, scored.truths, input.truth.size());
  const auto points = takeOptionalPoints(input, detections, found_label);
  std::vector<bool> correct(detections, false);
  const Overlaps all = countOverlaps(scored.true_label, scored.truths.size(), found_label, detections);
  for (const auto& [t, d] : segment(all, overlap).correct) correct[d] = true;
  for (std::size_t d = 0; d < detections; ++d) {
    if (with[d] != static_cast<int>(d)) continue;
    if (correct[d] || points[d].first <= points[d].second) scored.detections.push_back(static_cast<int>(d));
  }
  scored.found_label = renumbered(found_label, scored.detections, detections);
  return scored;
}

std::vector<Kind> kindsOf(const std::vector<Shape>& shapes) {
  std::vector<Kind> kinds;
  for (const Shape& shape : shapes) kinds.push_back(kindOf(shape));
  return kinds;
}

Vec3 middleOf(const Cloud& cloud, const std::vector<int>& labels, int label) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != label || !cloud.valid(i)) continue;
    sum += cloud.point(i);
    ++count;
  }
  return count > 0 ? Vec3(sum / count) : sum;
}

/// Adds to the counts of one kind and of all.
template <typename Number>
void addTo(CaseScore& score, Kind kind, Number Counts::*member, Number amount) {
  score.all.*member += amount;
  score.of_kind[static_cast<std::size_t>(kind)].*member += amount;
}

void scorePair(const LabelledCloud& input, const Scored& scored, int t, const Shape& truth, const Shape& found,
               CaseScore& score) {
  const Kind kind = kindOf(truth);
  const double dod = objectDistance(input.scored, scored.true_label, t, truth, found) / input.unit;
  addTo(score, kind, &Counts::correct, 1);
  addTo(score, kind, &Counts::dod, dod);
  if (kind != kindOf(found)) return;
  addTo(score, kind, &Counts::typed_correct, 1);
  addTo(score, kind, &Counts::typed_dod, dod);
  addErrors(truth, found, middleOf(input.scored, scored.true_label, t), score.errors[static_cast<std::size_t>(kind)]);
}

/// Which detections are right, and which of the others count; those of true shapes come with its index.
void judge(const Scored& scored, const std::vector<Kind>& true_kind, const std::vector<Kind>& found_kind,
           const Segmentation& segmentation, CaseScore& score) {
  for (const int d : scored.detections) score.verdicts[d] = Verdict::wrong;
  for (const auto& [t, d] : segmentation.correct) {
    if (true_kind[t] != found_kind[d]) continue;
    score.verdicts[scored.detections[d]] = Verdict::right;
    score.true_shape[scored.detections[d]] = scored.truths[t];
  }
}

void countInstances(const LabelledCloud& input, const Scored& scored, const std::vector<Shape>& true_shapes,
                    const std::vector<Shape>& found, CaseScore& score) {
  const std::vector<Kind> true_kind = kindsOf(true_shapes), found_kind = kindsOf(found);
  const Overlaps overlaps =
      countOverlaps(scored.true_label, true_shapes.size(), scored.found_label, scored.detections.size());
  const Segmentation segmentation = segment(overlaps, input.rules.overlap);
  for (const Kind kind : true_kind) addTo(score, kind, &Counts::truths, 1);
  for (const Kind kind : found_kind) addTo(score, kind, &Counts::found, 1);
  for (const int t : segmentation.missed) addTo(score, true_kind[t], &Counts::missed, 1);
  for (const int d : segmentation.noise) addTo(score, found_kind[d], &Counts::noise, 1);
  for (const int t : segmentation.over_segmented) addTo(score, true_kind[t], &Counts::over_segmented, 1);
  for (const int d : segmentation.under_segmented) addTo(score, found_kind[d], &Counts::under_segmented, 1);
  for (const auto& [t, d] : sameKindMatches(overlaps, true_kind, found_kind)) {
    addTo(score, true_kind[t], &Counts::type_right, 1);
  }
  judge(scored, true_kind, found_kind, segmentation, score);
  for (const auto& [t, d] : segmentation.correct) scorePair(input, scored, t, true_shapes[t], found[d], score);
}

int countFalseCurved(const LabelledCloud& input, const std::vector<Shape>& found,
                     const std::vector<Verdict>& verdicts) {
  int count = 0;
  for (std::size_t d = 0; d < found.size(); ++d) {
    const bool is_false = verdicts[d] == Verdict::wrong || input.recipe.set == "clutter";
    count += is_false && kindOf(found[d]) != Kind::plane ? 1 : 0;
  }
  return count;
}

/// Of each detection the kind of true shape that has most of its points.
std::vector<std::optional<Kind>> kindsBelow(const LabelledCloud& input, const std::vector<int>& labels,
                                            std::size_t detections) {
  const std::size_t none = input.truth.size();
  std::vector<std::vector<int>> points(detections, std::vector<int>(none + 1, 0));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0) continue;
    ++points[labels[i]][input.surface[i] >= 0 ? static_cast<std::size_t>(input.surface[i]) : none];
  }
  std::vector<std::optional<Kind>> kinds(detections);
  for (std::size_t d = 0; d < detections; ++d) {
    const std::size_t most = std::max_element(points[d].begin(), points[d].end()) - points[d].begin();
    if (most < none && points[d][most] > 0) kinds[d] = kindOf(input.truth[most].shape);
  }
  return kinds;
}

std::vector<double> curveEpsilons() {
  std::vector<double> epsilons(kCurvePoints);
  for (std::size_t k = 0; k < kCurvePoints; ++k) epsilons[k] = kCurveStep * static_cast<double>(k);
  return epsilons;
}

/// Coverage is about the points as they were measured; when the detector got a part of them, or in another order, those
/// that are scored.
const Cloud& measuredPoints(const LabelledCloud& input) { return isPointByPoint(input) ? input.cloud : input.scored; }

}  // namespace

Counts& Counts::operator+=(const Counts& other) {
  for (int Counts::*member :
       {&Counts::truths, &Counts::found, &Counts::correct, &Counts::typed_correct, &Counts::missed, &Counts::noise,
        &Counts::over_segmented, &Counts::under_segmented, &Counts::type_right}) {
    this->*member += other.*member;
  }
  dod += other.dod;
  typed_dod += other.typed_dod;
  return *this;
}

CaseScore scoreCase(const LabelledCloud& input, const std::vector<Shape>& found) {
  CaseScore score;
  const std::vector<int> labels = assign(input.scored, found, input.rules);
  const std::vector<int> with = joinedOnFaces(input, found, labels);
  const Scored scored = whatCounts(input, with, labels, input.rules.overlap);
  std::vector<Shape> true_shapes, kept;
  for (const int t : scored.truths) true_shapes.push_back(input.truth[t].shape);
  for (const int d : scored.detections) kept.push_back(found[d]);
  score.verdicts.assign(found.size(), Verdict::no_matter);
  score.true_shape.assign(found.size(), kNoShape);
  countInstances(input, scored, true_shapes, kept, score);
  for (std::size_t d = 0; d < found.size(); ++d) {
    score.verdicts[d] = score.verdicts[with[d]], score.true_shape[d] = score.true_shape[with[d]];
  }
  score.lies_on = kindsBelow(input, labels, found.size());
  score.false_curved = countFalseCurved(input, found, score.verdicts);
  const Distances distances = measureDistances(measuredPoints(input), found, labels);
  score.p_coverage = pointCoverage(distances, curveEpsilons());
  score.s_coverage = shapeCoverage(distances, labels, found.size(), curveEpsilons());
  score.points = static_cast<int>(input.scored.valid_count);
  return score;
}

}  // namespace primitect::eval
