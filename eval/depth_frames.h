// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Simulated depth frames of tables, heaps and halls with point-exact truth.
#pragma once

#include "eval/labelled_cloud.h"

namespace primitect::eval {

/// A true region with fewer pixels of 640 x 480, or as many of another size, need not be found.
constexpr std::uint32_t kLeastPixels = 900;

/// The frame of recipe.seed, of the set of depth frames that recipe.set names: 640 x 480 points, or as the recipe's
/// width says, within 2 m, without normals. Scored on the points of the surfaces themselves, without noise, and their
/// normals: a wall of a cup is thinner than the noise is wide. Shapes with fewer than kLeastPixels, or
/// nowhere five pixels wide (the rim of a box), and those seen from inside, need not be found. DOD in mm; a point
/// belongs to a detection within 20 mm. Throws std::invalid_argument for a noise scale out of range.
LabelledCloud depthFrame(const Recipe& recipe);

/// Once points were taken from such a frame: shapes of which fewer than kLeastPixels are left need not be found.
void excuseThinned(LabelledCloud& frame);

}  // namespace primitect::eval
