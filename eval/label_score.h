// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Do the points that carry a detection's label lie on the true shape that it is?
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "eval/case_score.h"
#include "eval/labelled_cloud.h"

namespace primitect::eval {

/// Measured points of one detection and of its true shape.
struct LabelScore {
  int labelled = 0;  ///< carry the detection's label
  int on_shape = 0;  ///< lie on the true shape
  int both = 0;
};

/// One a detection; none where it is not right, where several detections are of one true shape or that stands for
/// several surfaces, and for all where the detector got other points than those whose surface is known, or in another
/// order. labels: of Detector::label() for input.cloud. Throws std::invalid_argument when their number is not that of
/// the cloud's points.
std::vector<std::optional<LabelScore>> scoreLabels(const LabelledCloud& input, const std::vector<std::uint32_t>& labels,
                                                   const CaseScore& score);

}  // namespace primitect::eval
