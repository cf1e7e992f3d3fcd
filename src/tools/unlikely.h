// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Why is my object missing? What would come out if nothing were too unlikely, or of too few samples.
#pragma once

#include <cstdint>
#include <vector>

#include "primitect/primitives.h"
#include "tools/detect_input.h"

namespace primitect::tools {

/// Shapes below min_confidence that a second search, with min_confidence 0, finds mostly on points of which the first
/// made nothing: labels of the input's cloud by the first (Detector::label). The second may see the rest a little
/// differently, which is no matter here. In the frame of the sensor.
Detections tooUnlikely(const DetectInput& input, const std::vector<std::uint32_t>& labels);

/// As few samples as a shape may have without being chance, or as were asked for where that is less.
int fewestInliers(const Params& params);

/// The same for shapes that a search with min_inliers: fewestInliers() and min_votes: 0 finds.
Detections tooFew(const DetectInput& input, const std::vector<std::uint32_t>& labels);

}  // namespace primitect::tools
