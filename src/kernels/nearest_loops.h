// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the search for nearest neighbours takes and gives; see loops.h.
#pragma once

#include <cstddef>

namespace primitect::kernels {

constexpr std::size_t kLeafSize = 8;  ///< points of a leaf, and neighbours of a point

/// Corners of boxes along x, y and z. kLanes of them can be read at once anywhere.
struct LeafBoxes {
  const float *low[3], *high[3];
};

/// Points in leaves, kLanes leaves to a node. Points that are near each other in memory should be so in space.
struct LeafTree {
  const float *x, *y, *z;   ///< kLeafSize to a leaf; empty places are kFarAway
  LeafBoxes leaves, nodes;  ///< around them; of empty ones: kFarAway
  int place_bits;           ///< of a key: 2^n - 1, no less than the last place
};

constexpr float kFarAway = 1e18f;

/// The nearest kLeafSize neighbours, nearest first, of each point of a leaf: squared distance (m^2), in whose last bits
/// is the place of the neighbour. Such numbers can be sorted by the smaller and the larger of two alone, and where two
/// are as near, the one that comes first in memory is the first here. Of a float's 23 bits of fraction 10 are left for
/// the square where there are 8192 places, fewer where there are more: in double, exact to 1e-7, it took twice as long,
/// 3 % of a tabletop and 5 % of a paper scene more.
struct NearestKeys {
  alignas(64) float of[kLeafSize][kLeafSize];
};

constexpr float kNoNeighbor = 1e30f;  ///< and more

}  // namespace primitect::kernels
