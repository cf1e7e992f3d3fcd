// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals as the paper's data has them: estimated on the noisy cloud, turned like the true ones.
#pragma once

#include <cstddef>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::synthetic {

constexpr std::size_t kPaperNeighbors = 41;

/// Fills the cloud's normals by PCA over the nearest points, `neighbors` of them, the point itself included, each
/// turned to the side of `outward` (one a point). cell is the mean spacing of the points over x and y in m: speed only.
/// Throws std::invalid_argument for a cloud with missing points or with fewer than `neighbors`.
void estimateNormals(Cloud& cloud, double cell, const std::vector<Vec3>& outward,
                     std::size_t neighbors = kPaperNeighbors);

}  // namespace primitect::synthetic
