// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The axis along the rows, then the columns, then the rows; see listed_image.h.
#include "core/listed_image.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/lattice.h"
#include "core/random.h"

namespace primitect {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr std::size_t kFewestPairs = 50;  // pairs of points
constexpr double kNearPixel = 0.1;        // px
constexpr int kRefits = 2;

/// Draws what tells much more often than what tells little.
class Draw {
 public:
  /// tells: what each one tells, 0 and more, in any unit; what tells more than most counts for little more than these.
  explicit Draw(std::vector<double> tells) : weights_(std::move(tells)) {
    double mean = 0.0;
    for (const double weight : weights_) mean += weight / static_cast<double>(weights_.size());
    for (double& weight : weights_) {
      weight = mean > 0.0 ? weight / (weight + mean) : 1.0;
      sums_.push_back((sums_.empty() ? 0.0 : sums_.back()) + weight);
    }
  }

  std::size_t next() {
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), random_.uniform() * sums_.back());
    return std::min(static_cast<std::size_t>(found - sums_.begin()), sums_.size() - 1);
  }
  /// Of all that is told, what those tell that agree.
  template <class Agrees>
  double share(const Agrees& agrees) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < weights_.size(); ++i) sum += agrees(i) ? weights_[i] : 0.0;
    return sum / sums_.back();
  }

 private:
  Random random_{1};
  std::vector<double> weights_, sums_;
};

/// Of one row, mostly.
struct RowPair {
  Vec3 first, second;
};

/// Some of the points of a list, moved and scaled to lengths of about 1.
class PointsOfList {
 public:
  explicit PointsOfList(const Cloud& list) : list_(list) {
    constexpr std::size_t kEnough = 512, kTries = 16;
    Random random(1);
    for (std::size_t k = 0; k < kTries * kEnough && places_.size() < kEnough; ++k) {
      const std::size_t place = random.below(list.size());
      if (list.valid(place)) places_.push_back(place);
    }
    std::sort(places_.begin(), places_.end());
    const auto count = static_cast<double>(places_.size());
    for (const std::size_t place : places_) middle_ += list.point(place) / count;
    double square = 0.0;
    for (const std::size_t place : places_) square += (list.point(place) - middle_).squaredNorm() / count;
    if (square > 0.0) size_ = std::sqrt(square);
  }

  /// In the order of the list.
  const std::vector<std::size_t>& places() const { return places_; }
  Vec3 at(std::size_t place) const { return (list_.point(place) - middle_) / size_; }
  /// Each with the one that follows so many places later.
  std::vector<RowPair> pairs(std::size_t apart) const {
    std::vector<RowPair> result;
    for (const std::size_t place : places_) {
      if (place + apart < list_.size() && list_.valid(place + apart)) result.push_back({at(place), at(place + apart)});
    }
    return result;
  }

 private:
  const Cloud& list_;
  std::vector<std::size_t> places_;
  Vec3 middle_ = Vec3::Zero();  // m
  double size_ = 1.0;           // m
};

/// Where points follow each other in their row, about the width of a pixel; 0: they are in one place.
double usualStep(const std::vector<RowPair>& neighbours) {
  std::vector<double> steps;
  for (const RowPair& pair : neighbours) steps.push_back((pair.second - pair.first).norm());
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Through the centre of the camera, along its rows.
struct RowAxis {
  Vec3 along, through;  ///< unit; of its points the nearest to the origin

  /// How far the second point is from the plane of the axis and the first one.
  double offPlane(const RowPair& pair) const {
    return std::abs(along.cross(pair.first - through).normalized().dot(pair.second - through));
  }
};

/// Times the direction and the moment of a line it is 0 where the line through the pair meets it.
Vector6 equationOf(const RowPair& pair) {
  const Vec3 along = pair.second - pair.first;
  Vector6 equation;
  equation << pair.first.cross(pair.second), along;
  const double length = along.norm();
  return length > 0.0 ? Vector6(equation / length) : equation;
}

/// Nothing where the line is at infinity.
std::optional<RowAxis> axisOf(const Vector6& line) {
  constexpr double kNone = 1e-6;
  const double length = line.head<3>().norm();
  if (!(length > kNone * line.norm())) return std::nullopt;
  const Vec3 along = line.head<3>() / length;
  return RowAxis{along, along.cross(Vec3(line.tail<3>() / length))};
}

/// In which most pairs point, but for its sign and their length.
Vec3 commonDirection(const std::vector<RowPair>& pairs) {
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  for (const RowPair& pair : pairs) {
    const Vec3 along = (pair.second - pair.first).normalized();
    sums += along * along.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sums).eigenvectors().col(2);
}

/// From five pairs, the best of several draws. What is parallel to the rows, as of a wall before the camera, tells no
/// axis.
std::optional<RowAxis> drawAxis(const std::vector<RowPair>& pairs, double near) {
  constexpr int kDraws = 40, kDrawn = 5;
  constexpr double kNearlyAll = 0.9, kLeast = 0.5;  // of small parts of an image many pairs are of two rows
  const Vec3 common = commonDirection(pairs);
  std::vector<double> tells;
  for (const RowPair& pair : pairs) tells.push_back((pair.second - pair.first).normalized().cross(common).norm());
  Draw draw(std::move(tells));
  double most = kLeast;
  std::optional<RowAxis> best;
  for (int time = 0; time < kDraws && most < kNearlyAll; ++time) {
    Eigen::Matrix<double, 6, kDrawn> equations;
    for (int k = 0; k < kDrawn; ++k) equations.col(k) = equationOf(pairs[draw.next()]);
    const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 6, kDrawn>> qr(equations);
    const std::optional<RowAxis> axis = axisOf(qr.householderQ() * Vector6::Unit(kDrawn));
    if (!axis) continue;
    const double agree = draw.share([&](std::size_t i) { return axis->offPlane(pairs[i]) < near; });
    if (agree > most) most = agree, best = axis;
  }
  return best;
}

std::vector<RowPair> inOneRow(const RowAxis& axis, const std::vector<RowPair>& pairs, double near) {
  std::vector<RowPair> result;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(result),
               [&](const RowPair& pair) { return axis.offPlane(pair) < near; });
  return result;
}

/// By least squares from those of one row.
std::optional<RowAxis> fitAxis(const RowAxis& before, const std::vector<RowPair>& pairs, double near) {
  const std::vector<RowPair> in_row = inOneRow(before, pairs, near);
  if (in_row.size() < kFewestPairs) return before;
  Eigen::Matrix<double, 6, 6> sums = Eigen::Matrix<double, 6, 6>::Zero();
  for (const RowPair& pair : in_row) {
    const Vector6 equation = equationOf(pair);
    sums += equation * equation.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(sums);
  return axisOf(eigen.eigenvectors().col(0));
}

/// Pairs that are farther apart tell it the better the better it is known which of them are of one row.
std::optional<RowAxis> findAxis(const PointsOfList& points, double near) {
  constexpr std::size_t kDrawn = 4;
  const std::vector<RowPair> drawn = points.pairs(kDrawn);
  if (drawn.size() < kFewestPairs) return std::nullopt;
  std::optional<RowAxis> axis = drawAxis(drawn, near);
  for (const std::size_t apart : {4, 16, 64}) {
    const std::vector<RowPair> pairs = points.pairs(apart);
    for (int time = 0; axis && time < kRefits; ++time) axis = fitAxis(*axis, pairs, near);
  }
  return axis;
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
    steps.push_back({to * frame.along(pair.second) - from * frame.along(pair.first), to - from, from * first});
  }
  return steps;
}

/// From three steps of one column, the best of several draws. Steps at one distance from the axis tell no centre.
std::optional<Columns> drawColumns(const std::vector<ColumnStep>& steps) {
  constexpr int kDraws = 200;
  constexpr double kNearlyAll = 0.97, kLeast = 0.6;
  // px: steps on a wall or a table look nearly whole from other places, too, and from all if they were long enough.
  constexpr double kNearer = 0.03, kFarthest = 8.5;
  std::vector<double> tells;
  for (const ColumnStep& step : steps) tells.push_back(step.change != 0.0 ? std::abs(step.inverse / step.change) : 0.0);
  Draw draw(std::move(tells));
  double most = kLeast;
  std::optional<Columns> best;
  for (int time = 0; time < kDraws && most < kNearlyAll; ++time) {
    Eigen::Matrix3d equations;
    Vec3 changes;
    for (int k = 0; k < 3; ++k) {
      const ColumnStep& step = steps[draw.next()];
      equations.row(k) << step.inverse, step.to.transpose();
      changes[k] = step.change;
    }
    const Vec3 solved = equations.fullPivLu().solve(changes);
    const Columns columns = {solved[0], solved.tail<2>()};
    const double agree = draw.share([&](std::size_t i) {
      const double number = steps[i].columns(columns);
      return isWhole(number, kNearer) && std::abs(number) < kFarthest;
    });
    if (agree > most) most = agree, best = columns;
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
    if (!isWhole(number, kNearPixel)) continue;
    Vec3 equation;
    equation << step.inverse, std::round(number) * step.to;
    sums += equation * equation.transpose(), changes += step.change * equation;
    ++used;
  }
  if (used < kFewestPairs) return before;
  const Vec3 solved = sums.ldlt().solve(changes);
  return solved.allFinite() ? std::optional(Columns{solved[0], solved.tail<2>()}) : std::nullopt;
}

std::optional<Columns> findColumns(const PointsOfList& points, const OnAxis& frame, double near) {
  const auto steps = [&](std::size_t apart) { return columnSteps(frame, inOneRow(frame.axis, points.pairs(apart), near)); };
  const std::vector<ColumnStep> next = steps(1);
  if (next.size() < kFewestPairs) return std::nullopt;
  std::optional<Columns> columns = drawColumns(next);
  for (const std::size_t apart : {1, 8, 64}) {
    const std::vector<ColumnStep> longer = steps(apart);
    for (int time = 0; columns && time < kRefits; ++time) columns = fitColumns(*columns, longer);
  }
  return columns;
}

}  // namespace

std::vector<SeenPoint> findPixels(const Cloud& list) {
  // Of rows farther apart, or nearer, than columns by more than this there is no camera.
  constexpr double kLeastHeight = 0.2;  // times the width
  constexpr double kShort = 0.1;        // of the steps to other rows so many are short, from one to the next
  constexpr double kLongestStep = 0.1;  // of the size of all: what follows each other is not even near each other
  const PointsOfList points(list);
  const std::vector<RowPair> neighbours = points.pairs(1);
  if (neighbours.size() < kFewestPairs) return {};
  const double step = usualStep(neighbours);
  if (!(step < kLongestStep)) return {};
  const double near = kNearPixel * step;
  const std::optional<RowAxis> axis = findAxis(points, near);
  if (!axis) return {};
  const OnAxis frame(*axis);
  const std::optional<Columns> columns = findColumns(points, frame, near);
  if (!columns) return {};
  const double width = columns->width.norm();
  const Vec3 centre = axis->through + columns->centre * axis->along;
  // The camera looks at the points, which may have been listed from right to left.
  const double side = columns->width.x() < 0.0 ? -1.0 : 1.0;
  const Vec3 right = side * axis->along;
  const Vec3 ahead = side / width * (columns->width.x() * frame.ahead + columns->width.y() * frame.beside);
  const Vec3 down = ahead.cross(right);
  std::vector<SeenPoint> seen;
  List<double> across, below;
  for (const std::size_t place : points.places()) {
    const Vec3 to = points.at(place) - centre;
    if (!(ahead.dot(to) > 0.0)) continue;
    seen.push_back({list.point(place), Eigen::Vector2d::Zero()});
    across.push_back(right.dot(to) / ahead.dot(to)), below.push_back(down.dot(to) / ahead.dot(to));
  }
  const double height = stepAt(kShort, below, kLeastHeight * width);
  if (!(height > 0.0)) return {};
  const Lattice columns_at = latticeFrom(across, width), rows_at = latticeFrom(below, height);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen[i].pixel = {std::round(columns_at.place(across[i])), std::round(rows_at.place(below[i]))};
  }
  return seen;
}

}  // namespace primitect
