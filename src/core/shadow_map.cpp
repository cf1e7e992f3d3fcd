// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells of the plane; see shadow_map.h.
#include "core/shadow_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "core/lower_quartile.h"

namespace primitect {
namespace {

using Point = Eigen::Vector3f;

Point meanOf(const std::vector<Point>& points) {
  Point sum = Point::Zero();
  for (const Point& point : points) sum += point;
  return points.empty() ? sum : Point(sum / static_cast<float>(points.size()));
}

/// A floor may go on for a hundred metres, and a few points that chance to lie in the plane are anywhere.
void leaveOutFarOnes(std::vector<Point>& near) {
  constexpr float kReach = 3.0f;  // m
  if (near.empty()) return;
  Point middle = Point::Zero();
  List<double> along(near.size());
  for (const int axis : {0, 1}) {
    std::transform(near.begin(), near.end(), along.begin(), [axis](const Point& point) { return point[axis]; });
    middle[axis] = static_cast<float>(median(along));
  }
  const auto isFar = [&middle](const Point& point) { return !((point - middle).norm() < kReach); };
  near.erase(std::remove_if(near.begin(), near.end(), isFar), near.end());
}

}  // namespace

ShadowMap::ShadowMap(const Ground& ground, const std::vector<Point>& points) : offset_(ground.offset) {
  axes_.row(2) = ground.normal;
  axes_.row(0) = ground.normal.unitOrthogonal();
  axes_.row(1) = ground.normal.cross(axes_.row(0).transpose());
  std::vector<Point> near, above;
  for (const Point& point : points) {
    const Point moved = inFrameOfGround(point);
    if (std::abs(moved.z()) < kNearGround) near.push_back(moved);
    if (moved.z() > kAboveGround) above.push_back(moved);
  }
  leaveOutFarOnes(near);
  if (near.empty()) return;
  draw(near);
  keepSome(above);
  middle_of_ground_ = meanOf(near), middle_of_standing_ = meanOf(standing_);
}

void ShadowMap::keepSome(const std::vector<Point>& above) {
  std::vector<Point> standing;
  std::copy_if(above.begin(), above.end(), std::back_inserter(standing), [this](const Point& p) { return isOver(p); });
  const std::size_t step = standing.size() / kMostStanding + 1;
  for (std::size_t k = 0; k < standing.size(); k += step) standing_.push_back(standing[k]);
}

/// In cells so large that two points and more lie in those that are seen.
void ShadowMap::draw(const std::vector<Point>& near) {
  constexpr float kSmallest = 0.01f, kLarger = 1.4f;  // m
  constexpr int kSizes = 5;
  Point low = near.front(), high = near.front();
  for (const Point& point : near) low = low.cwiseMin(point), high = high.cwiseMax(point);
  left_ = low.x(), bottom_ = low.y();
  float cell = kSmallest;
  std::vector<std::uint8_t> seen;
  for (int k = 0; k < kSizes; ++k, cell *= kLarger) {
    per_cell_ = 1.0f / cell;
    const float wide = (high.x() - left_) * per_cell_, deep = (high.y() - bottom_) * per_cell_;
    columns_ = static_cast<int>(wide) + 1;
    rows_ = static_cast<int>(deep) + 1;
    seen.assign(static_cast<std::size_t>(columns_) * rows_, 0);
    std::size_t filled = 0;
    for (const Point& point : near) {
      const std::size_t c =
          at(static_cast<int>((point.x() - left_) * per_cell_), static_cast<int>((point.y() - bottom_) * per_cell_));
      filled += 1 - seen[c];
      seen[c] = 1;
    }
    if (near.size() >= 2 * filled) break;
  }
  findHoles(seen);
}

/// Holes lie between cells that are seen, along the rows as along the columns. The border of what is seen may be
/// either.
void ShadowMap::findHoles(const std::vector<std::uint8_t>& seen) {
  struct Range {
    int first = -1, last = -1;
    void add(int k) {
      if (first < 0) first = k;
      last = k;
    }
    bool holds(int k) const { return first < k && k < last; }
  };
  std::vector<Range> along_row(rows_), along_column(columns_);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (seen[at(column, row)]) along_row[row].add(column), along_column[column].add(row);
    }
  }
  cells_.assign(seen.size(), kOutside);
  for (int row = 1; row + 1 < rows_; ++row) {
    for (int column = 1; column + 1 < columns_; ++column) {
      const std::size_t c = at(column, row);
      if (!along_row[row].holds(column) || !along_column[column].holds(row)) continue;
      bool inside = true;
      for (const std::size_t begin : {c - columns_ - 1, c - 1, c + columns_ - 1})
        inside = inside && seen[begin] && seen[begin + 1] && seen[begin + 2];
      cells_[c] = inside ? kSeen : seen[c] ? kEither : kHole;
      holes_ += cells_[c] == kHole ? 1 : 0;
    }
  }
}

float ShadowMap::misfit(const Point& lamp, std::size_t point_count) {
  static constexpr std::array<int, kStates + 1> kMoreWrong = {0, 1, -1, 0};  // with a shadow on it, by state
  ++lamp_;
  int wrong = holes_;
  const std::size_t step = standing_.size() / point_count + 1;
  for (std::size_t k = 0; k < standing_.size(); k += step) {
    const Point& point = standing_[k];
    const float above = lamp.z() - point.z();
    if (!(above > 0.0f)) continue;  // its shadow falls nowhere
    const float stretch = point.z() / above;
    const float u = (point.x() + stretch * (point.x() - lamp.x()) - left_) * per_cell_ - 0.5f;
    const float v = (point.y() + stretch * (point.y() - lamp.y()) - bottom_) * per_cell_ - 0.5f;
    if (!(u >= 0.0f && v >= 0.0f && u < static_cast<float>(columns_ - 1) && v < static_cast<float>(rows_ - 1)))
      continue;
    // On the four cells around it: between the points there is no light.
    const std::size_t first = at(static_cast<int>(u), static_cast<int>(v));
    for (const std::size_t c : {first, first + 1, first + columns_, first + columns_ + 1}) {
      const std::uint32_t state = cells_[c] & kStates;
      // No branch: it would be guessed wrong half of the time.
      wrong += kMoreWrong[state] & -static_cast<int>(cells_[c] >> kStateBits != lamp_);
      cells_[c] = lamp_ << kStateBits | state;
    }
  }
  return static_cast<float>(wrong) / static_cast<float>(holes_);
}

}  // namespace primitect
