// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Random numbers all over an image, of which neighbours are alike.
#pragma once

#include <cstdint>
#include <vector>

#include "synthetic/camera.h"

namespace primitect::synthetic {

/// A number a pixel with mean 0 and variance 1, nearly Gaussian, none beyond 3.46 where grain is 1. grain: px, odd; of
/// pixels d columns (or rows) apart they have the correlation 1 - d / grain.
std::vector<float> noiseField(int grain, const PinholeCamera& camera, std::uint64_t seed);

/// The same without edges, as waves: half as much alike where pixels are about length px (odd) apart.
std::vector<float> waveField(int length, const PinholeCamera& camera, std::uint64_t seed);

}  // namespace primitect::synthetic
