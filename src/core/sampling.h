// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Drawing the samples: spread over the cloud, seeded, ordered so that neighbours in space are neighbours in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "core/samples.h"
#include "primitect/cloud.h"

namespace primitect {

/// Draws min(count, free points) samples: one at random from each of count equal runs of free points, then sorted along
/// the Z curve. Free are the valid points whose label is 0; without labels (empty) all valid ones are.
/// Normals are left missing. Same cloud, labels and seed, same samples.
void drawSamples(const Cloud& cloud, const std::vector<std::uint32_t>& labels, std::size_t count, std::uint64_t seed,
                 Samples& samples);

/// Diagonal of the samples' bounding box (m), the paper's scene diameter d_s; 0 without samples.
double boundingBoxDiagonal(const Samples& samples);

}  // namespace primitect
