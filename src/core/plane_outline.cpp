// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The parts of a plane that hold points, and the hull around them; see plane_outline.h.
#include "core/plane_outline.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/float_range.h"
#include "core/frame_around.h"
#include "core/frame_memory.h"
#include "core/hull.h"

namespace primitect {
namespace {

/// Enough to say which way a plane is longer. Prime: the step through the points is then seldom in time with
/// the rows of an image.
constexpr std::size_t kMostForDirection = 251;

/// Of the two signs of a direction this one, so that the pose does not flip.
Vec3 towardsPositiveX(const Vec3& direction) { return direction.x() < 0.0 ? Vec3(-direction) : direction; }

/// Direction of the largest spread of the points within the plane.
Vec3 longestDirection(const SomePoints<kMostForDirection>& points, const Vec3& mean, const Vec3& normal) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < points.count; ++k) {
    const Vec3 offset = points.point(k) - mean;
    scatter.noalias() += offset * offset.transpose();
  }
  const Eigen::Matrix3d within = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  scatter = (within * scatter * within).eval();
  const Vec3 direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
  return towardsPositiveX(direction);
}

/// The points in the frame of a plane (m, from the origin).
struct FlatPoints {
  List<float> u, v;

  FlatPoints(const SeenPoints& points, const Eigen::Matrix3d& rotation, const Vec3& origin)
      : u(points.size()), v(points.size()) {
    const Eigen::Vector3f x = rotation.col(0).cast<float>(), y = rotation.col(1).cast<float>();
    const Eigen::Vector3f from = (rotation.transpose() * (points.origin - origin)).cast<float>();
    for (std::size_t i = 0; i < u.size(); ++i) {
      u[i] = from.x() + x.x() * points.x[i] + x.y() * points.y[i] + x.z() * points.z[i];
      v[i] = from.y() + y.x() * points.x[i] + y.y() * points.y[i] + y.z() * points.z[i];
    }
  }
  Vec2 at(std::size_t i) const { return {u[i], v[i]}; }
};

/// Square cells over a box, some of them with points.
class Cells {
 public:
  explicit Cells(const FlatPoints& points) : cell_of_(points.u.size()) {
    const FloatRange in_u(points.u.data(), points.u.size()), in_v(points.v.data(), points.v.size());
    low_u_ = in_u.low, low_v_ = in_v.low;
    const float across = in_u.high - low_u_, down = in_v.high - low_v_;
    const float count = static_cast<float>(points.u.size());
    // Spacing of points spread over the box, or along a strip.
    const float spacing = std::max(std::sqrt(across * down / count), std::max(across, down) / count);
    const float cell = 3.0f * spacing;
    per_cell_ = cell > 0.0f ? 1.0f / cell : 0.0f;
    // One empty cell around all: no neighbour is outside.
    columns_ = static_cast<int>(across * per_cell_) + 3;
    rows_ = static_cast<int>(down * per_cell_) + 3;
    counts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    for (std::size_t i = 0; i < cell_of_.size(); ++i) {
      const int column = static_cast<int>((points.u[i] - low_u_) * per_cell_) + 1;
      const int row = static_cast<int>((points.v[i] - low_v_) * per_cell_) + 1;
      cell_of_[i] = row * columns_ + column;
      ++counts_[static_cast<std::size_t>(cell_of_[i])];
    }
  }

  /// Leaves the parts, of cells that touch each other, which hold at least a fifth of what the part with most points
  /// holds. A twentieth is enough in half of the cells that one has at most, as samples are denser where the first look
  /// explained nothing, and few may be in what is large; and in what is no strip, as a surface is that passes through
  /// the plane: beside a post in front of a wall an eighth of it may be seen.
  void keepParts() {
    constexpr double kShare = 0.2, kLeast = 0.05, kWide = 0.5;
    List<int> part(counts_.size(), 0), open;
    List<Part> parts(1);  // from 1 on
    for (std::size_t first = 0; first < counts_.size(); ++first) {
      if (counts_[first] == 0 || part[first] != 0) continue;
      parts.push_back(fill(static_cast<int>(first), static_cast<int>(parts.size()), part, open));
    }
    double most_points = 0.0, most_cells = 0.0;
    for (const Part& each : parts) {
      most_points = std::max(most_points, each.points), most_cells = std::max(most_cells, each.cells);
    }
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      const Part& of = parts[static_cast<std::size_t>(part[k])];
      const bool large = of.has_core || of.cells >= kWide * most_cells;
      if (of.points < (large ? kLeast : kShare) * most_points) counts_[k] = 0;
    }
  }

  /// Whether what is left holds a point in the cell of that one or in one that touches it.
  bool isNear(float u, float v) const {
    if (per_cell_ == 0.0f) return false;  // points in one place: a cell has no size
    const float column = (u - low_u_) * per_cell_ + 1.0f, row = (v - low_v_) * per_cell_ + 1.0f;
    const float columns = static_cast<float>(columns_), rows = static_cast<float>(rows_);
    if (!(column >= 0.0f && column < columns && row >= 0.0f && row < rows)) return false;
    const int at_column = static_cast<int>(column), at_row = static_cast<int>(row);
    for (int r = std::max(at_row - 1, 0); r <= std::min(at_row + 1, rows_ - 1); ++r) {
      for (int c = std::max(at_column - 1, 0); c <= std::min(at_column + 1, columns_ - 1); ++c) {
        if (count(r * columns_ + c) > 0) return true;
      }
    }
    return false;
  }

  /// Points that may be corners of the hull of all that are left. None of a cell whose four diagonal neighbours hold
  /// points is one: in whatever direction, one of these lies farther out.
  List<Vec2> border(const FlatPoints& points) const {
    List<char> at_border(counts_.size(), 0);
    for (int k = columns_ + 1; k + columns_ + 1 < static_cast<int>(counts_.size()); ++k) {
      const bool amid =
          count(k - columns_ - 1) && count(k - columns_ + 1) && count(k + columns_ - 1) && count(k + columns_ + 1);
      at_border[static_cast<std::size_t>(k)] = count(k) > 0 && !amid;
    }
    List<Vec2> result;
    for (std::size_t i = 0; i < cell_of_.size(); ++i) {
      if (at_border[static_cast<std::size_t>(cell_of_[i])]) result.push_back(points.at(i));
    }
    return result;
  }

 private:
  struct Part {
    double points = 0.0, cells = 0.0;
    bool has_core = false;  ///< a cell amid others that hold points
  };

  int count(int cell) const { return counts_[static_cast<std::size_t>(cell)]; }

  Part fill(int first, int number, List<int>& part, List<int>& open) const {
    Part held;
    open.assign(1, first);
    part[static_cast<std::size_t>(first)] = number;
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      held.points += count(at), held.cells += 1.0;
      int beside = 0;
      for (const int next : {at - columns_ - 1, at - columns_, at - columns_ + 1, at - 1, at + 1, at + columns_ - 1,
                             at + columns_, at + columns_ + 1}) {
        beside += count(next) > 0 ? 1 : 0;
        if (count(next) == 0 || part[static_cast<std::size_t>(next)] != 0) continue;
        part[static_cast<std::size_t>(next)] = number;
        open.push_back(next);
      }
      held.has_core = held.has_core || beside == 8;
    }
    return held;
  }

  float low_u_, low_v_, per_cell_;
  int columns_ = 0, rows_ = 0;
  List<int> counts_;
  List<int> cell_of_;  ///< of each point
};

}  // namespace

Extent outlineOf(const Plane& plane, const SeenPoints& inliers, const SeenPoints& outermost,
                 std::vector<Vec3> outline) {
  const SomePoints<kMostForDirection> some(inliers);
  const Vec3 mean = some.mean();
  Extent extent;
  extent.rotation = frameAround(plane.normal, longestDirection(some, mean, plane.normal));
  const FlatPoints flat(inliers, extent.rotation, inliers.origin);
  Cells cells(flat);
  cells.keepParts();
  List<Vec2> border = cells.border(flat);
  const FlatPoints flat_outermost(outermost, extent.rotation, inliers.origin);
  for (std::size_t i = 0; i < outermost.size(); ++i) {
    if (cells.isNear(flat_outermost.u[i], flat_outermost.v[i])) border.push_back(flat_outermost.at(i));
  }
  // A millimetre of a metre: less than the noise at a border, and half the corners.
  constexpr double kFlat = 1e-3;
  const Vec3 foot = inliers.origin - distance(plane, inliers.origin) * plane.normal;
  const Eigen::Matrix<double, 3, 2> axes = extent.rotation.leftCols<2>();
  const Rectangle along = rectangleAlong(Vec2::UnitX(), border);
  const List<Vec2> corners = convexHull(border, kFlat * along.size.norm());
  extent.hull = std::move(outline);
  extent.hull.clear();
  for (const Vec2& corner : corners) extent.hull.push_back(foot + axes * corner);
  // Points in one place have no hull.
  const Rectangle around = corners.empty() ? along : smallestRectangle(corners);
  extent.origin = foot + axes * around.middle;
  extent.size.head<2>() = around.size;
  extent.rotation = frameAround(plane.normal, towardsPositiveX(axes * around.x));
  return extent;
}

}  // namespace primitect
