// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Pieces that touch in a grid over the plane, and how well each lies level; see level_top.h.
#include "core/level_top.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/face_misfit.h"

namespace primitect {
namespace {

constexpr int kEmpty = -2, kWaiting = -1;  // in place of the number of a piece

/// More than chance makes of it, and than the waves of a depth camera do.
double margin(const List<std::uint32_t>& points) {
  constexpr double kSure = 15.0, kWaves = 0.03;
  return std::max(kSure, kWaves * static_cast<double>(points.size()));
}

}  // namespace

LevelTops::Grid::Grid(const Cloud& cloud, const Plane& plane, const List<std::uint32_t>& points)
    : across(plane.normal.unitOrthogonal()), down(plane.normal.cross(across)) {
  constexpr double kPointsPerCell = 4.0;
  constexpr int kFewest = 4, kMost = 32;
  cells = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(points.size()) / kPointsPerCell)), kFewest, kMost);
  low.setConstant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const std::uint32_t i : points) {
    const Vec3 point = cloud.point(i);
    const Eigen::Vector2d place(across.dot(point), down.dot(point));
    low = low.cwiseMin(place), high = high.cwiseMax(place);
  }
  per_meter = static_cast<double>(cells) / (high - low).array().max(1e-6);
}

int LevelTops::Grid::cellAt(const Vec3& point) const {
  const Eigen::Vector2d place(across.dot(point), down.dot(point));
  const Eigen::Array2i at = (place - low).cwiseProduct(per_meter).cast<int>().array().max(0).min(cells - 1);
  return at.y() * cells + at.x();
}

/// Itself, too.
template <class Use>
void LevelTops::forCellsAround(int cell, const Use& use) const {
  const int row = cell / grid_.cells, column = cell % grid_.cells, last = grid_.cells - 1;
  for (int r = std::max(0, row - 1); r <= std::min(last, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(last, column + 1); ++c) use(r * grid_.cells + c);
  }
}

/// Cells that touch, at a corner too, are one piece.
void LevelTops::findPieces(const Cloud& cloud, const List<std::uint32_t>& points) {
  List<int> cell_of;
  cell_of.reserve(points.size());
  piece_of_cell_.assign(static_cast<std::size_t>(grid_.cells) * grid_.cells, kEmpty);
  for (const std::uint32_t i : points) {
    cell_of.push_back(grid_.cellAt(cloud.point(i)));
    piece_of_cell_[cell_of.back()] = kWaiting;
  }
  int count = 0;
  List<int> front;
  for (const int first : cell_of) {
    if (piece_of_cell_[first] != kWaiting) continue;
    piece_of_cell_[first] = count;
    front.assign(1, first);
    while (!front.empty()) {
      const int cell = front.back();
      front.pop_back();
      forCellsAround(cell, [&](int other) {
        if (piece_of_cell_[other] != kWaiting) return;
        piece_of_cell_[other] = count;
        front.push_back(other);
      });
    }
    ++count;
  }
  pieces_.resize(count);
  for (std::size_t k = 0; k < points.size(); ++k) {
    Piece& piece = pieces_[piece_of_cell_[cell_of[k]]];
    piece.points.push_back(points[k]);
    piece.mean += cloud.point(points[k]);
  }
  for (Piece& piece : pieces_) piece.mean /= static_cast<double>(piece.points.size());
}

void LevelTops::measurePieces(const Cloud& cloud, const Vec3& level, const PointNoise& sigma) {
  for (Piece& piece : pieces_) {
    piece.misfit = misfit(cloud, piece.points, {piece.mean, level}, sigma);
    piece.uneven = unevenness(cloud, piece.points, {piece.mean, level}, sigma);
  }
}

/// Of no top yet, with the most points that lie level; of pieces that are less uneven than this, null where there is
/// none.
const LevelTops::Piece* LevelTops::mostLevel(double most_uneven) const {
  const Piece* best = nullptr;
  double most = -std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_) {
    if (piece.top != kNone) continue;
    const double agreed = static_cast<double>(piece.points.size()) - 0.5 * piece.misfit;
    if (!(agreed > most) || !(piece.uneven < most_uneven)) continue;
    most = agreed;
    best = &piece;
  }
  return best;
}

/// Of all pieces of no top yet that lie at this height.
void LevelTops::gatherTop(const Cloud& cloud, const Plane& at, const PointNoise& sigma) {
  Top top = {at, 0};
  Vec3 sum = Vec3::Zero();
  for (Piece& piece : pieces_) {
    if (piece.top != kNone) continue;
    if (misfit(cloud, piece.points, at, sigma) > piece.misfit + margin(piece.points)) continue;
    piece.top = static_cast<int>(tops_.size());
    top.count += piece.points.size();
    sum += static_cast<double>(piece.points.size()) * piece.mean;
  }
  top.plane.point = sum / static_cast<double>(top.count);
  tops_.push_back(top);
}

LevelTops::LevelTops(const Cloud& cloud, const Plane& plane, const Vec3& level, const PointNoise& sigma,
                     const List<std::uint32_t>& points)
    : grid_(cloud, plane, points) {
  constexpr double kMostTilt = 0.1;  // rad: steeper ones are no tops
  if (points.empty() || plane.normal.cross(level).norm() > kMostTilt) return;
  findPieces(cloud, points);
  if (pieces_.size() < 2) return;
  const Vec3 up = plane.normal.dot(level) < 0.0 ? Vec3(-level) : level;
  constexpr double kAny = std::numeric_limits<double>::infinity();
  measurePieces(cloud, up, sigma);
  const Piece* const found = mostLevel(kAny);
  if (!found) return;  // in a plane through the sensor, which sees none
  const Piece& main = *found;
  const double as_found = misfit(cloud, main.points, plane, sigma);
  if (main.misfit > as_found + margin(main.points)) return;
  gatherTop(cloud, {main.mean, up}, sigma);
  const double most_uneven = kAsEven * std::max(1.0, main.uneven);
  while (const Piece* next = mostLevel(most_uneven)) gatherTop(cloud, {next->mean, up}, sigma);
  if (tops_.front().count == points.size()) tops_.clear();
}

/// Those that were given leave some cells at its border empty.
int LevelTops::topAt(const Vec3& point) const {
  const int cell = grid_.cellAt(point);
  int piece = piece_of_cell_[cell];
  if (piece == kEmpty) forCellsAround(cell, [&](int other) { piece = std::max(piece, piece_of_cell_[other]); });
  return piece == kEmpty ? kNone : pieces_[piece].top;
}

}  // namespace primitect
