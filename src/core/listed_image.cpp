// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The axis along the rows, then the columns, then the rows; see listed_image.h.
#include "core/listed_image.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <utility>

#include "core/lattice.h"
#include "core/lower_quartile.h"
#include "core/row_axis.h"
#include "core/weighted_draw.h"

namespace primitect {
namespace {

constexpr double kNearPixel = 0.1;  // px

/// Where points follow each other in their row, about the width of a pixel; 0: they are in one place.
double usualStep(const std::vector<RowPair>& neighbours) {
  List<double> steps;
  for (const RowPair& pair : neighbours) steps.push_back((pair.second - pair.first).norm());
  return median(steps);
}

/// A frame on the axis of the rows.
struct OnAxis {
  RowAxis axis;
  Vec3 ahead, beside;  ///< unit, across the axis

  /// The points, whose mean is 0, lie ahead.
  explicit OnAxis(const RowAxis& row_axis)
      : axis(row_axis),
        ahead(row_axis.through.norm() > 0.0 ? Vec3(-row_axis.through.normalized()) : row_axis.along.unitOrthogonal()),
        beside(ahead.cross(axis.along)) {}

  double along(const Vec3& point) const { return axis.along.dot(point - axis.through); }
  Eigen::Vector2d across(const Vec3& point) const {
    return {ahead.dot(point - axis.through), beside.dot(point - axis.through)};
  }
};

/// Where the centre of the camera is on the axis, and how wide a column is, (a, b): ahead and beside.
struct Columns {
  double centre = 0.0;
  Eigen::Vector2d width = {0.0, 0.0};
};

/// From a point to another one of its row: change = centre * inverse + (columns from one to the other) * width . to
struct ColumnStep {
  double change, inverse;
  Eigen::Vector2d to;  ///< unit, across the axis

  double columns(const Columns& columns) const { return (change - columns.centre * inverse) / columns.width.dot(to); }
};

std::vector<ColumnStep> columnSteps(const OnAxis& frame, const std::vector<RowPair>& in_row) {
  std::vector<ColumnStep> steps;
  for (const RowPair& pair : in_row) {
    const Eigen::Vector2d first = frame.across(pair.first), second = frame.across(pair.second);
    const double from = 1.0 / first.norm(), to = 1.0 / second.norm();
    if (!std::isfinite(from) || !std::isfinite(to)) continue;  // on the axis
    steps.push_back({to * frame.along(pair.second) - from * frame.along(pair.first), to - from, from * first});
  }
  return steps;
}

/// How well columns explain steps: of all that steps tell, the share of those that are whole, and the sum of that over
/// how many columns they lead. Depths that are rounded to whole disparities, as structured light does, are whole from
/// other centres on the axis, too, 1.2 m away for some cameras; but only from the right one most steps are of one
/// column.
struct Agreement {
  double whole = 0.0, single = 0.0;
};

Agreement agreementOf(const Columns& columns, const std::vector<ColumnStep>& steps, const WeightedDraw& draw) {
  // px: steps on a wall or a table look nearly whole from other places, too, and from all if they were long enough.
  constexpr double kNearer = 0.03, kFarthest = 8.5;
  Agreement agreement;
  draw.forEach([&](std::size_t i, double share) {
    const double number = std::abs(steps[i].columns(columns));
    if (!isWholeAndNotZero(number, kNearer) || !(number < kFarthest)) return;
    agreement.whole += share;
    agreement.single += share / std::round(number);
  });
  return agreement;
}

/// The middle of the points, at 0 and so far from the axis, is in view, and columns are as wide as those of cameras.
bool mayBeOfACamera(const Columns& columns, double distance) {
  constexpr double kWidest = 2.0;                             // tangent: beyond it no camera sees
  constexpr double kNarrowColumn = 1e-5, kWideColumn = 0.03;  // tangents
  const double width = columns.width.norm();
  return std::abs(columns.centre) < kWidest * distance && width > kNarrowColumn && width < kWideColumn;
}

/// From three steps of one column, the best of several draws. Steps at one distance from the axis tell no centre.
std::optional<Columns> drawColumns(const std::vector<ColumnStep>& steps, double distance) {
  constexpr int kDraws = 400;
  constexpr double kSurely = 0.99, kMostlySingle = 0.85, kLeast = 0.6;
  List<double> tells;
  for (const ColumnStep& step : steps) tells.push_back(std::abs(step.inverse / step.change));
  WeightedDraw draw(std::move(tells));
  Agreement most;
  std::optional<Columns> best;
  for (int time = 0; time < kDraws && !(most.whole > kSurely && most.single > kMostlySingle); ++time) {
    Eigen::Matrix3d equations;
    Vec3 changes;
    for (int k = 0; k < 3; ++k) {
      const ColumnStep& step = steps[draw.next()];
      equations.row(k) << step.inverse, step.to.transpose();
      changes[k] = step.change;
    }
    const Vec3 solved = equations.fullPivLu().solve(changes);
    const Columns columns = {solved[0], solved.tail<2>()};
    if (!mayBeOfACamera(columns, distance)) continue;
    const Agreement agreement = agreementOf(columns, steps, draw);
    if (agreement.whole > kLeast && agreement.single > most.single) most = agreement, best = columns;
  }
  return best;
}

/// By least squares from the steps that are whole.
std::optional<Columns> fitColumns(const Columns& before, const std::vector<ColumnStep>& steps) {
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  Vec3 changes = Vec3::Zero();
  std::size_t used = 0;
  for (const ColumnStep& step : steps) {
    const double number = step.columns(before);
    if (!isWholeAndNotZero(number, kNearPixel)) continue;
    Vec3 equation;
    equation << step.inverse, std::round(number) * step.to;
    sums += equation * equation.transpose(), changes += step.change * equation;
    ++used;
  }
  if (used < kFewestRowPairs) return before;
  const Vec3 solved = sums.ldlt().solve(changes);
  return solved.allFinite() ? std::optional(Columns{solved[0], solved.tail<2>()}) : std::nullopt;
}

std::optional<Columns> findColumns(const PointsOfList& points, const OnAxis& frame, double near) {
  constexpr int kRefits = 2;
  const auto steps = [&](std::size_t apart) {
    return columnSteps(frame, inOneRow(frame.axis, points.pairs(apart), near));
  };
  const std::vector<ColumnStep> next = steps(1);
  if (next.size() < kFewestRowPairs) return std::nullopt;
  std::optional<Columns> columns = drawColumns(next, frame.axis.through.norm());
  for (const std::size_t apart : {1, 8, 64}) {
    const std::vector<ColumnStep> longer = steps(apart);
    for (int time = 0; columns && time < kRefits; ++time) columns = fitColumns(*columns, longer);
  }
  return columns;
}

/// The camera, in the scale of PointsOfList.
struct ListCamera {
  Vec3 centre, right, down, ahead;  ///< the axes are unit
  double column;                    ///< how wide one is, as a tangent
};

std::optional<ListCamera> findListCamera(const PointsOfList& points) {
  constexpr double kLongestStep = 0.1;  // of the size of all: what follows each other is not even near each other
  const std::vector<RowPair> neighbours = points.pairs(1);
  if (neighbours.size() < kFewestRowPairs) return std::nullopt;
  const double step = usualStep(neighbours), near = kNearPixel * step;
  if (!(step < kLongestStep)) return std::nullopt;
  const std::optional<RowAxis> axis = findRowAxis(points, near);
  if (!axis) return std::nullopt;
  const OnAxis frame(*axis);
  const std::optional<Columns> columns = findColumns(points, frame, near);
  if (!columns) return std::nullopt;
  const double column = columns->width.norm();
  // The camera looks at the points, which may have been listed from right to left.
  const double side = columns->width.x() < 0.0 ? -1.0 : 1.0;
  const Vec3 right = side * axis->along;
  const Vec3 ahead = side / column * (columns->width.x() * frame.ahead + columns->width.y() * frame.beside);
  return ListCamera{axis->through + columns->centre * axis->along, right, ahead.cross(right), ahead, column};
}

}  // namespace

std::vector<SeenPoint> findPixels(const Cloud& list) {
  constexpr double kBehind = 0.1;       // strays; more, and no camera saw them all
  constexpr double kLeastHeight = 0.2;  // of a row, times the width of a column: of others there is no camera
  constexpr double kShort = 0.1;        // of the steps to other rows so many are short, from one to the next
  const PointsOfList points(list);
  const std::optional<ListCamera> camera = findListCamera(points);
  if (!camera) return {};
  std::vector<SeenPoint> seen;
  List<double> across, below;
  for (const std::size_t place : points.places()) {
    const Vec3 to = points.at(place) - camera->centre;
    const double depth = camera->ahead.dot(to);
    if (!(depth > 0.0)) continue;
    seen.push_back({list.point(place), Eigen::Vector2d::Zero()});
    across.push_back(camera->right.dot(to) / depth), below.push_back(camera->down.dot(to) / depth);
  }
  if (static_cast<double>(seen.size()) < (1.0 - kBehind) * static_cast<double>(points.places().size())) return {};
  const double row = stepAt(kShort, below, kLeastHeight * camera->column);
  if (!(row > 0.0)) return {};
  const Lattice columns = latticeFrom(across, camera->column), rows = latticeFrom(below, row);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen[i].pixel = {std::round(columns.place(across[i])), std::round(rows.place(below[i]))};
  }
  return seen;
}

}  // namespace primitect
