// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Objects seen from above on the paper's grid, and the noisy cloud that comes of it.
#pragma once

#include <vector>

#include "core/random.h"
#include "synthetic/paper_dataset.h"
#include "synthetic/paper_objects.h"

namespace primitect::synthetic {

/// What is seen at each grid point.
struct PaperRendering {
  std::vector<Vec3> points;
  std::vector<int> owner;  ///< index of the object
  std::vector<int> owned;  ///< points of each object
};

/// Orthographic view along -z onto the 401 x 401 grid, the largest z wins. The first object is seen where no other is.
PaperRendering renderFromAbove(const std::vector<PaperObject>& objects);

/// The scene of rendered objects: noise, outliers, normals. Objects without points are no part of the truth.
PaperScene sceneOf(const std::vector<PaperObject>& objects, PaperRendering seen, double sigma, double outlier_share,
                   Random& random);

/// Throws std::invalid_argument for a sigma or share that the paper's scenes cannot have; see makePaperScene().
void checkNoise(double sigma, double outlier_share);

}  // namespace primitect::synthetic
