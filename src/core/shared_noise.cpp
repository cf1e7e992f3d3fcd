// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums of residuals over cells of the surface; see shared_noise.h.
#include "core/shared_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/noise.h"
#include "core/residuals.h"

namespace primitect {
namespace {

/// Of one cell: sum of the weighted residuals, and number of points.
struct Cell {
  double sum = 0.0;
  double count = 0.0;
};

struct Member {
  Vec3 place;  ///< on the surface, from any origin: a cell must not collect the points of one side
  double psi;  ///< Tukey's biweight of the residual
};

/// A box around the members cut into about thirty cells that meet the surface.
std::vector<Cell> cellsOf(const std::vector<Member>& members) {
  constexpr double kCells = 30.0, kMostAlong = 100.0;
  Vec3 low = members.front().place, high = low;
  for (const Member& m : members) {
    low = low.cwiseMin(m.place);
    high = high.cwiseMax(m.place);
  }
  const Vec3 size = high - low;
  const double longest = size.maxCoeff(), shortest = size.minCoeff();
  const double middle = size.sum() - longest - shortest;
  const double edge = std::max({std::sqrt(longest * middle / kCells), longest / kMostAlong, 1e-9});
  const Eigen::Array3i counts = (size / edge).array().cast<int>() + 1;
  std::vector<Cell> cells(static_cast<std::size_t>(counts.prod()));
  for (const Member& m : members) {
    const Eigen::Array3i at = ((m.place - low) / edge).array().cast<int>();
    Cell& cell = cells[static_cast<std::size_t>((at.z() * counts.y() + at.y()) * counts.x() + at.x())];
    cell.sum += m.psi;
    cell.count += 1.0;
  }
  return cells;
}

}  // namespace

double measureSharedNoise(const Shape& shape, const SeenPoints& inliers,
                          const std::function<double(const Vec3&)>& sigma) {
  constexpr std::size_t kMostPoints = 2039;
  const SomePoints<kMostPoints> points(inliers);
  const auto feet = Feet<SomePoints<kMostPoints>::kRoom>(shape, points);
  std::vector<Member> members;
  members.reserve(points.count);
  double total = 0.0;
  for (std::size_t k = 0; k < points.count; ++k) {
    const double away = feet.distance[k];
    const double share_of_limit = away / (kInlierDeviations * sigma(points.point(k)));
    if (!(std::abs(share_of_limit) < 1.0)) continue;
    const double root = 1.0 - share_of_limit * share_of_limit;
    const Vec3 normal(feet.nx[k], feet.ny[k], feet.nz[k]), place(points.x[k], points.y[k], points.z[k]);
    members.push_back({place - away * normal, share_of_limit * root * root});
    total += members.back().psi * members.back().psi;
  }
  if (members.empty() || !(total > 0.0)) return 1.0;
  double sums_sq = 0.0, counts_sq = 0.0;
  for (const Cell& cell : cellsOf(members)) {
    sums_sq += cell.sum * cell.sum;
    counts_sq += cell.count * cell.count;
  }
  // As many cells of equal size; the fit has made the sums smaller in as many ways as it has parameters.
  const double cells = static_cast<double>(members.size() * members.size()) / counts_sq;
  const double freedom = cells - parameterCount(kindOf(shape));
  if (!(freedom > 1.0)) return 1.0;
  const double growth = sums_sq / total * cells / freedom;
  const double chance = 2.0 * std::sqrt(2.0 / freedom);
  if (!(growth > 1.0 + chance)) return 1.0;
  // Of all points, that many times more lie within reach of each other.
  return 1.0 + (growth - 1.0) / points.share;
}

}  // namespace primitect
