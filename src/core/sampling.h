// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Drawing the samples: spread over the cloud, seeded, ordered so that neighbours in space are neighbours in memory.
#pragma once

#include <cstdint>

#include "core/samples.h"
#include "primitect/cloud.h"

namespace primitect {

/// Draws min(count, valid points) samples: one at random from each of count equal runs of valid points, then sorted
/// along the Z curve. Normals are left missing. Same cloud and seed, same samples.
void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples);

/// Diagonal of the samples' bounding box (m), the paper's scene diameter d_s; 0 without samples.
double boundingBoxDiagonal(const Samples& samples);

}  // namespace primitect
