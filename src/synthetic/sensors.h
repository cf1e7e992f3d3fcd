// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The faults of usual kinds of depth cameras.
#pragma once

#include <string>
#include <vector>

#include "synthetic/noise.h"

namespace primitect::synthetic {

/// "structured_light", "bent_structured_light", "stereo", "time_of_flight".
const std::vector<std::string>& sensorNames();

/// structured_light  NoiseParams() as it is: noise of single pixels
/// bent_structured_light
///                   the same with waves of .25 % of the depth over 71 px; recorded Kinects bend tables by .2 to .5 %
/// stereo            noise of .06 px of the disparity, 2.3 mm at 1 m, 9 mm at 2 m, shared by 7 x 7 pixels; shadows;
///                   small steps smeared over 3 px, large ones lost; waves of .15 % of the depth
/// time_of_flight    noise of single pixels; flying pixels along every edge; waves of .15 % of the depth
/// Throws std::invalid_argument for other names.
NoiseParams noiseOf(const std::string& sensor);

}  // namespace primitect::synthetic
