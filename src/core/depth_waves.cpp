// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Squares of second differences between cells, by their distance (cf. the variogram of Matheron, 1963); see
// depth_waves.h.
#include "core/depth_waves.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "core/float_range.h"

namespace primitect {
namespace {

constexpr double kCell = 0.03;  // of x / z and y / z: 16 pixels of a usual camera
constexpr std::array kCellsApart = {1, 2, 3, 4, 6, 8, 12};
constexpr float kFewestInCell = 2.0f;

/// Points of one cell: relative errors of the depth.
struct Cell {
  float count = 0.0f, sum = 0.0f, squares = 0.0f;
  bool tells() const { return count >= kFewestInCell; }
  double mean() const { return sum / count; }
};

/// Where points are seen (x / z, y / z), and 1 / z, which of a plane is linear in these.
struct InverseDepths {
  List<float> u, v, inverse;

  explicit InverseDepths(const SeenPoints& points) {
    for (List<float>* values : {&u, &v, &inverse}) values->resize(points.size());
    const Eigen::Vector3f origin = points.origin.cast<float>();
    for (std::size_t k = 0; k < points.size(); ++k) {
      inverse[k] = 1.0f / (origin.z() + points.z[k]);
      u[k] = (origin.x() + points.x[k]) * inverse[k];
      v[k] = (origin.y() + points.y[k]) * inverse[k];
    }
  }
};

/// Relative errors of the depths, from the plane of least squares. u and v are counted from the middle.
List<float> errorsOf(const InverseDepths& p, float middle_u, float middle_v) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < p.u.size(); ++k) {
    const Eigen::Vector3d row(p.u[k] - middle_u, p.v[k] - middle_v, 1.0);
    normal += row * row.transpose();
    right += row * static_cast<double>(p.inverse[k]);
  }
  const Eigen::Vector3f plane = normal.ldlt().solve(right).cast<float>();
  List<float> errors(p.u.size());
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const float fitted = plane.x() * (p.u[k] - middle_u) + plane.y() * (p.v[k] - middle_v) + plane.z();
    errors[k] = fitted / p.inverse[k] - 1.0f;
  }
  return errors;
}

/// Cells of one plane in rows.
struct Cells {
  int columns = 0, rows = 0;
  List<Cell> all;
  double variance = 0.0;  ///< of single points within their cells
  int telling = 0;

  const Cell& at(int column, int row) const { return all[static_cast<std::size_t>(row * columns + column)]; }
};

Cells cellsOf(const InverseDepths& p) {
  constexpr float kMostAlong = 200.0f;
  const FloatRange u(p.u.data(), p.u.size()), v(p.v.data(), p.v.size());
  Cells cells;
  const float per_cell = 1.0f / static_cast<float>(kCell);
  if (!((u.high - u.low) * per_cell < kMostAlong && (v.high - v.low) * per_cell < kMostAlong)) return cells;
  const List<float> errors = errorsOf(p, 0.5f * (u.low + u.high), 0.5f * (v.low + v.high));
  cells.columns = static_cast<int>((u.high - u.low) * per_cell) + 1;
  cells.rows = static_cast<int>((v.high - v.low) * per_cell) + 1;
  cells.all.resize(static_cast<std::size_t>(cells.columns * cells.rows));
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const int column = static_cast<int>((p.u[k] - u.low) * per_cell);
    const int row = static_cast<int>((p.v[k] - v.low) * per_cell);
    Cell& cell = cells.all[static_cast<std::size_t>(row * cells.columns + column)];
    cell.count += 1.0f, cell.sum += errors[k], cell.squares += errors[k] * errors[k];
  }
  double within = 0.0, freedom = 0.0;
  for (const Cell& cell : cells.all) {
    if (!cell.tells()) continue;
    ++cells.telling;
    within += cell.squares - cell.sum * cell.mean();
    freedom += cell.count - 1.0;
  }
  cells.variance = freedom > 0.0 ? within / freedom : 0.0;
  return cells;
}

}  // namespace

void WaveFinder::see(const SeenPoints& plane) {
  static_assert(kCellsApart.size() == kDistances);
  constexpr std::size_t kFewestPoints = 256;
  constexpr int kFewestCells = 40;
  if (plane.size() < kFewestPoints) return;
  const Cells cells = cellsOf(InverseDepths(plane));
  if (cells.telling < kFewestCells) return;
  for (std::size_t d = 0; d < kDistances; ++d) {
    const int apart = kCellsApart[d];
    const auto compare = [&](const Cell& before, const Cell& cell, const Cell& after) {
      if (!before.tells() || !cell.tells() || !after.tells()) return;
      const double noise = 1.0 / before.count + 4.0 / cell.count + 1.0 / after.count;
      const double bend = before.mean() - 2.0 * cell.mean() + after.mean();
      seen_[d].sum += bend * bend / noise - cells.variance;
      seen_[d].weight += 1.0 / noise;
      seen_[d].chance += 2.0 * cells.variance * cells.variance;
    };
    for (int row = 0; row < cells.rows; ++row) {
      for (int column = apart; column + apart < cells.columns; ++column) {
        compare(cells.at(column - apart, row), cells.at(column, row), cells.at(column + apart, row));
      }
    }
    for (int row = apart; row + apart < cells.rows; ++row) {
      for (int column = 0; column < cells.columns; ++column) {
        compare(cells.at(column, row - apart), cells.at(column, row), cells.at(column, row + apart));
      }
    }
  }
}

/// By least squares, beside a part that is the same at all distances: noise that only neighbouring pixels share.
WaveFinder::Fit WaveFinder::fitted(double reach) const {
  constexpr double kAlone = 6.0;  // mean square of a bend, of independent errors with variance 1
  const DepthWaves unit = {1.0, reach};
  std::array<double, kDistances> of_waves;  // the same of waves
  double squares = 0.0;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t d = 0; d < kDistances; ++d) {
    const double apart_sq = std::pow(kCell * kCellsApart[d], 2);
    of_waves[d] = kAlone - 8.0 * unit.alike(apart_sq) + 2.0 * unit.alike(4.0 * apart_sq);
    if (!(seen_[d].weight > 0.0)) continue;
    const Eigen::Vector2d row(of_waves[d], kAlone);
    normal += seen_[d].weight * row * row.transpose();
    right += seen_[d].sum * row;
    squares += seen_[d].sum * seen_[d].sum / seen_[d].weight;
  }
  Eigen::Vector2d best = normal.ldlt().solve(right);
  const bool any_alone = best[1] > 0.0;
  if (!any_alone) best = {right[0] / normal(0, 0), 0.0};
  // How much each sum counts for the share.
  const double mean = any_alone ? normal(0, 1) / normal(1, 1) * kAlone : 0.0;
  const double spread = normal(0, 0) - mean / kAlone * normal(0, 1);
  double variance = 0.0;
  for (std::size_t d = 0; d < kDistances; ++d) variance += std::pow((of_waves[d] - mean) / spread, 2) * seen_[d].chance;
  return {best[0], std::sqrt(variance), squares - 2.0 * best.dot(right) + best.dot(normal * best)};
}

DepthWaves WaveFinder::waves() const {
  constexpr double kReaches[] = {1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0};  // cells
  // Of 150 tables, halls and households without waves none had some, with 4 two; of 40 stereo frames with waves one had
  // none.
  constexpr double kSure = 5.0;
  DepthWaves waves;
  if (!(seen_[0].weight > 0.0 && seen_[kDistances / 2].weight > 0.0)) return waves;
  double least = std::numeric_limits<double>::infinity();
  for (const double cells : kReaches) {
    const Fit fit = fitted(cells * kCell);
    if (!(fit.share_sq > kSure * fit.deviation) || !(fit.misfit < least)) continue;
    least = fit.misfit;
    waves = {std::sqrt(fit.share_sq), cells * kCell};
  }
  return waves;
}

}  // namespace primitect
