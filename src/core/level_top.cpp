// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Pieces that touch in a grid over the plane, and how well each lies level; see level_top.h.
#include "core/level_top.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace primitect {
namespace {

/// A grid over the plane with a few points in each cell.
class Grid {
 public:
  Grid(const Cloud& cloud, const Plane& plane, const List<std::uint32_t>& points) {
    constexpr double kPointsPerCell = 4.0;
    constexpr int kFewest = 4, kMost = 32;
    cells_ =
        std::clamp(static_cast<int>(std::sqrt(static_cast<double>(points.size()) / kPointsPerCell)), kFewest, kMost);
    const Vec3 across = plane.normal.unitOrthogonal(), down = plane.normal.cross(across);
    List<Eigen::Vector2d> places;
    places.reserve(points.size());
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const std::uint32_t i : points) {
      const Vec3 point(cloud.x[i], cloud.y[i], cloud.z[i]);
      places.emplace_back(across.dot(point), down.dot(point));
      low = low.cwiseMin(places.back()), high = high.cwiseMax(places.back());
    }
    const Eigen::Vector2d per_meter = static_cast<double>(cells_) / (high - low).array().max(1e-6);
    cell_of_.reserve(points.size());
    for (const Eigen::Vector2d& place : places) {
      const auto line = [this](double value) { return std::clamp(static_cast<int>(value), 0, cells_ - 1); };
      const Eigen::Vector2d at = (place - low).cwiseProduct(per_meter);
      cell_of_.push_back(line(at.y()) * cells_ + line(at.x()));
    }
  }

  /// Number of the piece of each point; cells that touch, at a corner too, are one piece. Returns how many there are.
  int findPieces(List<int>& piece_of_point) const {
    constexpr int kEmpty = -2, kWaiting = -1;
    List<int> piece(static_cast<std::size_t>(cells_) * cells_, kEmpty);
    for (const int cell : cell_of_) piece[cell] = kWaiting;
    int count = 0;
    List<int> front;
    for (const int first : cell_of_) {
      if (piece[first] != kWaiting) continue;
      piece[first] = count;
      front.assign(1, first);
      while (!front.empty()) {
        const int cell = front.back(), row = cell / cells_, column = cell % cells_;
        front.pop_back();
        for (int r = std::max(0, row - 1); r <= std::min(cells_ - 1, row + 1); ++r) {
          for (int c = std::max(0, column - 1); c <= std::min(cells_ - 1, column + 1); ++c) {
            if (piece[r * cells_ + c] != kWaiting) continue;
            piece[r * cells_ + c] = count;
            front.push_back(r * cells_ + c);
          }
        }
      }
      ++count;
    }
    piece_of_point.clear();
    for (const int cell : cell_of_) piece_of_point.push_back(piece[cell]);
    return count;
  }

 private:
  int cells_;
  List<int> cell_of_;
};

struct Piece {
  List<std::uint32_t> points;
  Vec3 mean = Vec3::Zero();
};

/// How badly a plane fits: squares of the distances in standard deviations; what is far off counts as three of these.
double misfit(const Cloud& cloud, const Piece& piece, const Vec3& normal, const Vec3& through,
              const PointNoise& sigma) {
  constexpr double kMost = 9.0;
  double sum = 0.0;
  for (const std::uint32_t i : piece.points) {
    const Vec3 point(cloud.x[i], cloud.y[i], cloud.z[i]);
    const double away = normal.dot(point - through) / sigma(point);
    sum += std::min(away * away, kMost);
  }
  return sum;
}

/// More than chance makes of it, and than the waves of a depth camera do.
double margin(const Piece& piece) {
  constexpr double kSure = 15.0, kWaves = 0.03;
  return std::max(kSure, kWaves * static_cast<double>(piece.points.size()));
}

List<Piece> piecesOf(const Cloud& cloud, const Plane& plane, const List<std::uint32_t>& points) {
  List<int> number;
  List<Piece> pieces(Grid(cloud, plane, points).findPieces(number));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::uint32_t i = points[k];
    pieces[number[k]].points.push_back(i);
    pieces[number[k]].mean += Vec3(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  for (Piece& piece : pieces) piece.mean /= static_cast<double>(piece.points.size());
  return pieces;
}

/// With the most points that lie level.
const Piece& mainPiece(const Cloud& cloud, const List<Piece>& pieces, const Vec3& level, const PointNoise& sigma) {
  const Piece* best = &pieces.front();
  double most = -std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces) {
    const double agreed =
        static_cast<double>(piece.points.size()) - 0.5 * misfit(cloud, piece, level, piece.mean, sigma);
    if (!(agreed > most)) continue;
    most = agreed;
    best = &piece;
  }
  return *best;
}

}  // namespace

List<std::uint32_t> levelTop(const Cloud& cloud, const Plane& plane, const Vec3& level, const PointNoise& sigma,
                             const List<std::uint32_t>& points) {
  constexpr double kMostTilt = 0.1;  // rad: steeper ones are no tops
  if (points.empty() || plane.normal.cross(level).norm() > kMostTilt) return points;
  const List<Piece> pieces = piecesOf(cloud, plane, points);
  if (pieces.size() < 2) return points;
  const Piece& main = mainPiece(cloud, pieces, level, sigma);
  const double as_found = misfit(cloud, main, plane.normal, plane.point, sigma);
  if (misfit(cloud, main, level, main.mean, sigma) > as_found + margin(main)) return points;
  List<std::uint32_t> kept;
  for (const Piece& piece : pieces) {
    const double at_its_height = misfit(cloud, piece, level, main.mean, sigma);
    if (at_its_height > misfit(cloud, piece, level, piece.mean, sigma) + margin(piece)) continue;
    kept.insert(kept.end(), piece.points.begin(), piece.points.end());
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace primitect
