// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Why is my object missing? What would come out with more time, or if nothing were too unlikely or of too few samples.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "primitect/primitives.h"
#include "tools/detect_input.h"

namespace primitect::tools {

/// Shapes that were not reported, mostly on points of which nothing else was made. In the frame of the sensor.
struct Unreported {
  std::optional<Detections> late;      ///< where time was bounded: what there was none for
  std::optional<Detections> unlikely;  ///< with verify: below min_confidence, of a search with min_confidence: 0
  Detections few_inliers;  ///< with too few samples or votes: of one with min_inliers: fewestInliers(), min_votes: 0
};

/// By searches with all effort. They may see what was reported a little differently, which is no matter. labels: of the
/// input's points by the search that was reported (Detector::label); hurried: with max_latency.
Unreported searchUnreported(const DetectInput& input, bool hurried, std::vector<std::uint32_t> labels);

/// As few samples as any shape needs where a frame has little effort, or as are asked for where that is less.
int fewestInliers(const Params& params);

}  // namespace primitect::tools
