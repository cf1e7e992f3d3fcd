// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lines that meet a line; see row_axis.h.
#include "core/row_axis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/random.h"
#include "core/weighted_draw.h"

namespace primitect {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Times the direction and the moment of a line it is 0 where the line through the pair meets it.
Vector6 meetingOf(const RowPair& pair) {
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

/// Most pairs from all over the list are of several rows, and nearly all points on one side: not so of an axis in the
/// plane of the points, which all lines through two of them meet.
bool partsRows(const RowAxis& axis, const std::vector<RowPair>& far_apart, double near) {
  constexpr double kMost = 0.3, kBehind = 0.02;
  const auto all = static_cast<double>(far_apart.size());
  const auto together = static_cast<double>(inOneRow(axis, far_apart, near).size());
  // The mean of the points is 0.
  const auto behind = std::count_if(far_apart.begin(), far_apart.end(), [&axis](const RowPair& pair) {
    return axis.through.dot(pair.first - axis.through) >= 0.0 || axis.through.dot(pair.second - axis.through) >= 0.0;
  });
  return together < kMost * all && static_cast<double>(behind) <= kBehind * all;
}

/// From five pairs, the best of several draws. What is parallel to the rows, as of a wall before the camera, tells no
/// axis.
std::optional<RowAxis> drawAxis(const std::vector<RowPair>& pairs, const std::vector<RowPair>& far_apart, double near) {
  constexpr int kDraws = 40, kDrawn = 5;
  constexpr double kNearlyAll = 0.97, kLeast = 0.5;  // of small parts of an image many pairs are of two rows
  const Vec3 common = commonDirection(pairs);
  List<double> tells;
  for (const RowPair& pair : pairs) tells.push_back((pair.second - pair.first).normalized().cross(common).norm());
  WeightedDraw draw(std::move(tells));
  double most = kLeast;
  std::optional<RowAxis> best;
  for (int time = 0; time < kDraws && most < kNearlyAll; ++time) {
    Eigen::Matrix<double, 6, kDrawn> equations;
    for (int k = 0; k < kDrawn; ++k) equations.col(k) = meetingOf(pairs[draw.next()]);
    const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 6, kDrawn>> qr(equations);
    const std::optional<RowAxis> axis = axisOf(qr.householderQ() * Vector6::Unit(kDrawn));
    if (!axis) continue;
    const double agree = draw.share([&](std::size_t i) { return axis->offPlane(pairs[i]) < near; });
    if (agree > most && partsRows(*axis, far_apart, near)) most = agree, best = axis;
  }
  return best;
}

/// By least squares from those of one row; as before where that loses some of them, as of points in a plane it may.
RowAxis fitAxis(const RowAxis& before, const std::vector<RowPair>& pairs, const std::vector<RowPair>& far_apart,
                double near) {
  constexpr double kKept = 0.95;
  const std::vector<RowPair> in_row = inOneRow(before, pairs, near);
  if (in_row.size() < kFewestRowPairs) return before;
  Eigen::Matrix<double, 6, 6> sums = Eigen::Matrix<double, 6, 6>::Zero();
  for (const RowPair& pair : in_row) {
    const Vector6 equation = meetingOf(pair);
    sums += equation * equation.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(sums);
  const std::optional<RowAxis> axis = axisOf(eigen.eigenvectors().col(0));
  const auto least = kKept * static_cast<double>(in_row.size());
  if (!axis || !partsRows(*axis, far_apart, near)) return before;
  return static_cast<double>(inOneRow(*axis, in_row, near).size()) >= least ? *axis : before;
}

}  // namespace

PointsOfList::PointsOfList(const Cloud& list) : list_(list) {
  constexpr std::size_t kEnough = 512, kTries = 16;
  if (list.valid_count == 0) return;
  Random random(1);
  for (std::size_t k = 0; k < kTries * kEnough && places_.size() < kEnough; ++k) {
    const std::size_t place = random.below(list.size());
    if (list.valid(place)) places_.push_back(place);
  }
  std::sort(places_.begin(), places_.end());
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  const auto count = static_cast<double>(places_.size());
  for (const std::size_t place : places_) middle_ += list.point(place) / count;
  double square = 0.0;
  for (const std::size_t place : places_) square += (list.point(place) - middle_).squaredNorm() / count;
  if (square > 0.0) size_ = std::sqrt(square);
}

std::vector<RowPair> PointsOfList::pairs(std::size_t apart) const {
  std::vector<RowPair> result;
  for (const std::size_t place : places_) {
    if (place + apart < list_.size() && list_.valid(place + apart)) result.push_back({at(place), at(place + apart)});
  }
  return result;
}

std::vector<RowPair> PointsOfList::farPairs() const {
  std::vector<RowPair> result;
  const std::size_t half = places_.size() / 2;
  for (std::size_t i = 0; i < half; ++i) result.push_back({at(places_[i]), at(places_[i + half])});
  return result;
}

double RowAxis::offPlane(const RowPair& pair) const {
  const Vec3 normal = along.cross(pair.first - through);
  const double length = normal.norm();
  return length > 0.0 ? std::abs(normal.dot(pair.second - through)) / length : std::numeric_limits<double>::infinity();
}

std::vector<RowPair> inOneRow(const RowAxis& axis, const std::vector<RowPair>& pairs, double near) {
  std::vector<RowPair> result;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(result),
               [&](const RowPair& pair) { return axis.offPlane(pair) < near; });
  return result;
}

/// Pairs that are farther apart tell it the better, the better it is known which of them are of one row.
std::optional<RowAxis> findRowAxis(const PointsOfList& points, double near) {
  constexpr std::size_t kDrawn = 4;
  constexpr int kRefits = 2;
  const std::vector<RowPair> drawn = points.pairs(kDrawn);
  if (drawn.size() < kFewestRowPairs) return std::nullopt;
  const std::vector<RowPair> far_apart = points.farPairs();
  std::optional<RowAxis> axis = drawAxis(drawn, far_apart, near);
  for (const std::size_t apart : {4, 16, 64}) {
    const std::vector<RowPair> pairs = points.pairs(apart);
    for (int time = 0; axis && time < kRefits; ++time) axis = fitAxis(*axis, pairs, far_apart, near);
  }
  return axis;
}

}  // namespace primitect
