// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// All that is measured about one method on one cloud.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "eval/labelled_cloud.h"
#include "eval/parameter_errors.h"

namespace primitect::eval {

/// Coverage curves are taken at 0, 0.002, ... 0.05 m.
constexpr double kCurveStep = 0.002;
constexpr std::size_t kCurvePoints = 26;

/// Counts of one kind, or of all kinds together. Truths that need not be found, and detections of these, are left out.
struct Counts {
  int truths = 0, found = 0;
  int correct = 0, typed_correct = 0;
  int missed = 0, noise = 0, over_segmented = 0, under_segmented = 0;
  int type_right = 0;      ///< true shapes whose best-overlapping detection, one to one, has their kind
  double dod = 0.0;        ///< sum over the correct pairs, in units of the cloud
  double typed_dod = 0.0;  ///< sum over those with the right kind
  Counts& operator+=(const Counts& other);
};

/// What became of a detection: right: of the right kind and correct by SegComp; no_matter: it lies mostly on shapes
/// that need not be found.
enum class Verdict { right, wrong, no_matter };

struct CaseScore {
  Counts all;
  std::array<Counts, kKindCount> of_kind;  ///< truths and pairs by the true kind, found and noise by the found kind
  std::array<ParameterErrors, kKindCount> errors;
  std::vector<double> p_coverage;  ///< kCurvePoints shares in [0, 1]
  std::vector<double> s_coverage;  ///< the same, or empty when no detection has points
  int points = 0;                  ///< measured points of the cloud
  std::vector<Verdict> verdicts;   ///< one a detection
  std::vector<int> true_shape;     ///< one a detection: index in the truth of a right one, otherwise kNoShape
  /// One a detection: kind of the true shape, must it be found or not, that most of its points lie on; none when these
  /// are points of no shape.
  std::vector<std::optional<Kind>> lies_on;
  /// Spheres, cylinders and cones that are wrong; on a "clutter" frame all of them.
  int false_curved = 0;
};

/// Scores what a method found. Points of shapes that need not be found count for nobody; a detection that lies mostly
/// on such points is neither right nor wrong.
CaseScore scoreCase(const LabelledCloud& input, const std::vector<Shape>& found);

}  // namespace primitect::eval
