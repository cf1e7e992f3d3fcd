// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What depth cameras do to a depth image (m, NaN = missing) besides noise.
#pragma once

#include <cstdint>
#include <vector>

#include "synthetic/camera.h"

namespace primitect::synthetic {

/// Every pixel that saw anything measures the mean of what the width * width pixels around it saw (width: px, odd). At
/// edges that is a depth between, where nothing is: flying pixels.
void mixNeighbors(int width, const PinholeCamera& camera, std::vector<float>& depth);

/// Removes what a projector or second camera does not see that is so far (baseline, m) to the left of this one: beside
/// everything near a shadow on what lies behind, fx * baseline (1 / near - 1 / far) px wide.
void removeShadows(double baseline, const PinholeCamera& camera, std::vector<float>& depth);

/// Every depth becomes longer or shorter by a share of itself, with this standard deviation, in waves of this length
/// (waveField).
void bend(double share, int length, const PinholeCamera& camera, std::uint64_t seed, std::vector<float>& depth);

/// Removes this share of the image, in blots of about grain px (odd).
void removeBlots(double share, int grain, const PinholeCamera& camera, std::uint64_t seed, std::vector<float>& depth);

}  // namespace primitect::synthetic
