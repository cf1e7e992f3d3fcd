// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The synthetic data set of the paper: scenes of random shapes seen from above, with noise, normals and exact truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::synthetic {

enum class SceneKind { spheres, cylinders, cones, planes, mixed };
constexpr std::size_t kSceneKindCount = 5;

/// "spheres", "cylinders", "cones", "planes", "mixed".
const char* sceneKindName(SceneKind kind);

/// Throws std::invalid_argument naming the text and the known kinds.
SceneKind sceneKindFromName(const std::string& name);

/// One scene with its truth, m.
struct PaperScene {
  /// 160,801 points, unorganized, in the raster order of a 401 x 401 grid over x and y in [-2, 2]; no point is missing.
  /// Normals by PCA over the 41 nearest points, the point itself included, turned like the noiseless ones (n_z >= 0).
  Cloud cloud;
  std::vector<Shape> truth;  ///< the shapes that own points; [0] is the background plane if it is seen at all
  std::vector<int> owned;    ///< points of each of them, before some became outliers
  std::vector<int> surface;  ///< index in truth of each point's shape, -1 for an outlier
};

/// Draws the scene with this seed (paper, section Datasets; orthographic view along -z, the largest z wins).
/// sigma: standard deviation of the noise on x, y and z in m; outlier_share: part of the points, in [0, 1), that is
/// thrown evenly into the bounding box. The same seed gives the same shapes at every sigma and share.
/// Throws std::invalid_argument for a sigma or share out of range.
PaperScene makePaperScene(SceneKind kind, std::uint64_t seed, double sigma, double outlier_share = 0.0);

}  // namespace primitect::synthetic
