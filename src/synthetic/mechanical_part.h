// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Point clouds of machined parts with exact truth, in the style of the traceparts set of SPFN (Li et al. 2019).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::synthetic {

/// Points of one part. Its largest side, before it is turned at random around its middle, the origin, is 1.
struct MechanicalPart {
  /// Unorganized, no point missing, spread evenly over all sides of the part. Normals by PCA over the kPartNeighbors
  /// nearest points, turned like the exact ones.
  Cloud cloud;
  std::vector<Vec3> normals;  ///< exact, at the noiseless points, out of the material
  std::vector<Shape> truth;   ///< each shape once, however many faces lie on it; planes: normal out of the material
  std::vector<bool> concave;  ///< of each shape: the material is around it (holes, dimples, countersinks)
  std::vector<int> surface;   ///< index in truth of each point's shape; -1: its shape has too few points
};

/// With 8096 points the paper's 41 neighbours reach 0.06 around a point: over most holes and chamfers, so that a third
/// of the normals would be off by more than 15 deg even without noise; with 20 it is a quarter.
constexpr std::size_t kPartNeighbors = 20;

/// A shape with fewer points is no part of the truth.
constexpr int kMinPartPoints = 40;

/// Draws the part with this seed. The noise is uniform in [-noise_half_width, noise_half_width] along the exact normal:
/// across the surface is where it matters, and the points stay spread evenly over it.
/// The same seed gives the same part at any noise. Throws std::invalid_argument for a half width outside 0 to 0.1 or
/// fewer than 500 points.
MechanicalPart makeMechanicalPart(std::uint64_t seed, double noise_half_width, std::size_t points = 8096);

}  // namespace primitect::synthetic
