// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Small objects on the paper's grid: the paper's own data set has none that owns less than 2 % of the points.
#pragma once

#include <cstdint>

#include "synthetic/paper_dataset.h"

namespace primitect::synthetic {

/// Shares of the points that a small object owns when nothing hides a part of it.
constexpr double kSmallestShare = 0.003, kSmallShareLimit = 0.02;

/// 6 to 10 spheres, cylinders, cones (both of finite length) and triangles, of each kind about equally many, over the
/// paper's background plane and rendered, disturbed and given normals like the paper's scenes. Shares of the points are
/// spread evenly over their logarithm, from kSmallestShare to kSmallShareLimit; what hides an object in part may take
/// it below. As in the paper's scenes open ends of cylinders and cones are not closed and their inside is not seen.
/// Triangles are tilted against the background by 25 deg and more: an extended plane runs into it otherwise.
/// sigma, outlier_share and errors: as makePaperScene().
PaperScene makeSmallScene(std::uint64_t seed, double sigma, double outlier_share = 0.0);

}  // namespace primitect::synthetic
