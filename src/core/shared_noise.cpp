// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums of residuals over cells of the surface; see shared_noise.h.
#include "core/shared_noise.h"

#include <algorithm>
#include <cmath>

#include "core/frame_memory.h"
#include "core/noise.h"
#include "core/residuals.h"

namespace primitect {
namespace {

/// Of one cell: sum of the weighted residuals, and number of points.
struct Cell {
  double sum = 0.0;
  double count = 0.0;
};

/// Points of a surface with Tukey's biweight of their residuals.
struct Members {
  static constexpr std::size_t kMost = 2039;
  std::size_t count = 0;
  double psi_sq = 0.0;  ///< sum
  /// On the surface (m, from any origin): a cell must not collect the points of one side.
  float x[kMost], y[kMost], z[kMost];
  float psi[kMost];
};

void findMembers(const Shape& shape, const SomePoints<Members::kMost>& points, const PointNoise& sigma,
                 Members& members) {
  const auto feet = Feet<SomePoints<Members::kMost>::kRoom>(shape, points);
  float one[SomePoints<Members::kMost>::kRoom];
  sigma.at(points, one);
  for (std::size_t k = 0; k < points.count; ++k) {
    const float away = feet.distance[k];
    const float share = away / (static_cast<float>(kInlierDeviations) * one[k]);
    if (!(std::abs(share) < 1.0f)) continue;
    const float root = 1.0f - share * share, psi = share * root * root;
    const std::size_t at = members.count++;
    members.x[at] = points.x[k] - away * feet.nx[k];
    members.y[at] = points.y[k] - away * feet.ny[k];
    members.z[at] = points.z[k] - away * feet.nz[k];
    members.psi[at] = psi;
    members.psi_sq += static_cast<double>(psi) * psi;
  }
}

/// A box around the members cut into about thirty cells that meet the surface.
List<Cell> cellsOf(const Members& members) {
  constexpr float kCells = 30.0f, kMostAlong = 100.0f;
  Eigen::Array3f low(members.x[0], members.y[0], members.z[0]), high = low;
  for (std::size_t k = 0; k < members.count; ++k) {
    const Eigen::Array3f place(members.x[k], members.y[k], members.z[k]);
    low = low.min(place);
    high = high.max(place);
  }
  const Eigen::Array3f size = high - low;
  const float longest = size.maxCoeff(), shortest = size.minCoeff();
  const float middle = size.sum() - longest - shortest;
  const float per_edge = 1.0f / std::max({std::sqrt(longest * middle / kCells), longest / kMostAlong, 1e-9f});
  const Eigen::Array3i counts = (size * per_edge).cast<int>() + 1;
  List<Cell> cells(static_cast<std::size_t>(counts.prod()));
  for (std::size_t k = 0; k < members.count; ++k) {
    const int column = static_cast<int>((members.x[k] - low.x()) * per_edge);
    const int row = static_cast<int>((members.y[k] - low.y()) * per_edge);
    const int layer = static_cast<int>((members.z[k] - low.z()) * per_edge);
    Cell& cell = cells[static_cast<std::size_t>((layer * counts.y() + row) * counts.x() + column)];
    cell.sum += members.psi[k];
    cell.count += 1.0;
  }
  return cells;
}

}  // namespace

double measureSharedNoise(const Shape& shape, const SeenPoints& inliers, const PointNoise& sigma) {
  const SomePoints<Members::kMost> points(inliers);
  Members members;
  findMembers(shape, points, sigma, members);
  if (members.count == 0 || !(members.psi_sq > 0.0)) return 1.0;
  double sums_sq = 0.0, counts_sq = 0.0;
  for (const Cell& cell : cellsOf(members)) {
    sums_sq += cell.sum * cell.sum;
    counts_sq += cell.count * cell.count;
  }
  // As many cells of equal size; the fit has made the sums smaller in as many ways as it has parameters.
  const double cells = static_cast<double>(members.count * members.count) / counts_sq;
  const double freedom = cells - parameterCount(kindOf(shape));
  if (!(freedom > 1.0)) return 1.0;
  const double growth = sums_sq / members.psi_sq * cells / freedom;
  const double chance = 2.0 * std::sqrt(2.0 / freedom);
  if (!(growth > 1.0 + chance)) return 1.0;
  // Of all points, that many times more lie within reach of each other.
  return 1.0 + (growth - 1.0) / points.share;
}

}  // namespace primitect
