// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums of residuals over cells of the surface; see shared_noise.h.
#include "core/shared_noise.h"

#include <algorithm>
#include <cmath>

#include "core/flat_gradients.h"
#include "core/float_range.h"
#include "core/frame_memory.h"
#include "core/noise.h"
#include "core/residuals.h"

namespace primitect {
namespace {

/// Of one cell: sum of the weighted residuals, and number of points.
struct Cell {
  float sum = 0.0f;
  float count = 0.0f;
};

constexpr std::size_t kMostShared = 2039;
using Points = SomePoints<kMostShared>;

/// Points of a surface with Tukey's biweight of their residuals; those beyond it have none, and count for nothing.
struct Members {
  double psi_sq = 0.0;  ///< sum
  /// On the surface (m, from any origin): a cell must not collect the points of one side.
  float x[Points::kRoom], y[Points::kRoom], z[Points::kRoom];
  float psi[Points::kRoom], once[Points::kRoom];
};

/// Without branches: a third fewer instructions.
void findMembers(const Shape& shape, const Points& points, const PointNoise& sigma, Members& __restrict members) {
  const auto feet = Feet<Points::kRoom>(shape, points);
  float one[Points::kRoom];
  sigma.at(points, one);
  for (std::size_t k = 0; k < points.count; ++k) {
    const float away = feet.distance[k];
    const float share = away / (static_cast<float>(kInlierDeviations) * one[k]);
    const float root = std::max(1.0f - share * share, 0.0f);  // worked out for all: four at once
    members.once[k] = root > 0.0f ? 1.0f : 0.0f;
    members.psi[k] = share * root * root;
    members.x[k] = points.x[k] - away * feet.nx[k];
    members.y[k] = points.y[k] - away * feet.ny[k];
    members.z[k] = points.z[k] - away * feet.nz[k];
  }
  members.psi_sq = sumOfProducts(members.psi, members.psi, points.count);
}

/// A box around the points cut into about thirty cells that meet the surface.
List<Cell> cellsOf(const Members& members, std::size_t count) {
  constexpr float kCells = 30.0f, kMostAlong = 100.0f;
  const FloatRange x(members.x, count), y(members.y, count), z(members.z, count);
  const Eigen::Array3f size(x.high - x.low, y.high - y.low, z.high - z.low);
  const float longest = size.maxCoeff(), shortest = size.minCoeff();
  // Of points on a line it is nothing, but for rounding, which may make it less.
  const float middle = std::max(0.0f, size.sum() - longest - shortest);
  const float per_edge = 1.0f / std::max({std::sqrt(longest * middle / kCells), longest / kMostAlong, 1e-9f});
  const Eigen::Array3i counts = (size * per_edge).cast<int>() + 1;
  List<Cell> cells(static_cast<std::size_t>(counts.prod()));
  int cell_of[Points::kRoom];
  const auto columns = static_cast<float>(counts.x()), rows = static_cast<float>(counts.y());
  const auto whole = [per_edge](float from_low) { return static_cast<float>(static_cast<int>(from_low * per_edge)); };
  for (std::size_t k = 0; k < count; ++k) {
    // In float, which has all digits of so few cells: integers are not multiplied four at once everywhere.
    const float column = whole(members.x[k] - x.low), row = whole(members.y[k] - y.low);
    cell_of[k] = static_cast<int>((whole(members.z[k] - z.low) * rows + row) * columns + column);
  }
  for (std::size_t k = 0; k < count; ++k) {
    Cell& cell = cells[static_cast<std::size_t>(cell_of[k])];
    cell.sum += members.psi[k];
    cell.count += members.once[k];
  }
  return cells;
}

/// growth: of independent noise the square of a cell's sum is as large as the squares of its points together, in the
/// mean; here it is so many times as large. Of points that share one deviation it would be their number, were cells
/// large. In an image noise of points d apart in a row may be alike by 1 - d / g, as the mean of a window of g by g
/// points is: in cells of c by c points it grows by (g - (g^2 - 1) / (3 c))^2 instead of g^2, as long as g <= c. Seen
/// at a slant, cells are not square, and noise grows less in them.
double inLargerCells(double growth, double points_in_cell) {
  constexpr double kFewest = 9.0;  // that hold a grain at all
  if (points_in_cell < kFewest) return growth;
  const double c = std::sqrt(points_in_cell);
  const double root = std::min(std::sqrt(growth), (2.0 * c * c + 1.0) / (3.0 * c));  // what it is of g = c
  const double g = 0.5 * (3.0 * c - std::sqrt(std::max(9.0 * c * c - 4.0 * (3.0 * c * root - 1.0), 0.0)));
  return std::max(g * g, growth);
}

}  // namespace

SharedNoise measureSharedNoise(const Shape& shape, const SeenPoints& inliers, const PointNoise& sigma) {
  const Points points(inliers);
  Members members;
  findMembers(shape, points, sigma, members);
  if (!(members.psi_sq > 0.0)) return {};
  double sums_sq = 0.0, counts_sq = 0.0, count = 0.0;
  for (const Cell& cell : cellsOf(members, points.count)) {
    sums_sq += static_cast<double>(cell.sum) * cell.sum;
    counts_sq += static_cast<double>(cell.count) * cell.count;
    count += cell.count;
  }
  // As many cells of equal size; the fit has made the sums smaller in as many ways as it has parameters.
  const double cells = count * count / counts_sq;
  const double freedom = cells - parameterCount(kindOf(shape));
  if (!(freedom > 1.0)) return {};
  const double growth = sums_sq / members.psi_sq * cells / freedom;
  const double chance = 2.0 * std::sqrt(2.0 / freedom);
  if (!(growth > 1.0 + chance)) return {};
  // Of all points, that many times more lie within reach of each other.
  const double shown = 1.0 + (growth - 1.0) / points.share;
  return {shown, inLargerCells(shown, count / cells / points.share)};
}

}  // namespace primitect
