// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Exact nearest neighbours for clouds that lie evenly over x and y: faster there than a tree, with the same result.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "primitect/cloud.h"

namespace primitect::synthetic {

/// Points sorted into square cells over x and y. A search gathers all points within a guessed radius, which a grid
/// finds completely, and is exact as soon as these are enough; otherwise the radius grows.
class NeighborGrid {
 public:
  /// cell is the side of a cell in m. Throws std::invalid_argument for an empty cloud or one with missing points.
  NeighborGrid(const Cloud& cloud, float cell) : cloud_(cloud), cell_(cell) {
    if (cloud.size() == 0 || cloud.valid_count != cloud.size()) {
      throw std::invalid_argument("neighbor grid: the cloud is empty or has missing points");
    }
    const auto [x_min, x_max] = std::minmax_element(cloud.x.begin(), cloud.x.end());
    const auto [y_min, y_max] = std::minmax_element(cloud.y.begin(), cloud.y.end());
    x_min_ = *x_min;
    y_min_ = *y_min;
    columns_ = static_cast<int>((*x_max - x_min_) / cell_) + 1;
    rows_ = static_cast<int>((*y_max - y_min_) / cell_) + 1;
    sortIntoCells();
  }

  /// Indices of the points, cell by cell: searching in this order makes the radius guessed from the last search fit.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// The count points nearest to point i, itself included, in no particular order; of equally far ones those with the
  /// smaller index. Throws std::invalid_argument for a count of 0 or above that of the cloud's points.
  void nearest(std::uint32_t i, std::size_t count, std::vector<std::uint32_t>& neighbors) {
    if (count == 0 || count > cloud_.size()) {
      throw std::invalid_argument("neighbor grid: " + std::to_string(count) + " neighbours of " +
                                  std::to_string(cloud_.size()) + " points");
    }
    for (float radius = 1.1f * last_radius_;; radius *= 1.5f) {
      gather(i, radius);
      if (found_.size() >= count) break;
    }
    std::nth_element(found_.begin(), found_.begin() + (count - 1), found_.end());
    last_radius_ = std::max(std::sqrt(found_[count - 1].distance_sq), 0.1f * cell_);
    neighbors.resize(count);
    for (std::size_t k = 0; k < count; ++k) neighbors[k] = found_[k].index;
  }

 private:
  struct Found {
    float distance_sq;
    std::uint32_t index;
    bool operator<(const Found& other) const {
      return distance_sq != other.distance_sq ? distance_sq < other.distance_sq : index < other.index;
    }
  };

  int column(float x) const { return std::clamp(static_cast<int>(std::floor((x - x_min_) / cell_)), 0, columns_ - 1); }
  int row(float y) const { return std::clamp(static_cast<int>(std::floor((y - y_min_) / cell_)), 0, rows_ - 1); }
  std::size_t cellOf(std::size_t i) const {
    return static_cast<std::size_t>(row(cloud_.y[i])) * columns_ + column(cloud_.x[i]);
  }

  void sortIntoCells() {
    first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    for (std::size_t i = 0; i < cloud_.size(); ++i) ++first_[cellOf(i) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    order_.resize(cloud_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < cloud_.size(); ++i) order_[next[cellOf(i)]++] = static_cast<std::uint32_t>(i);
  }

  void gather(std::uint32_t i, float radius) {
    found_.clear();
    const float x = cloud_.x[i], y = cloud_.y[i], z = cloud_.z[i];
    const int left = column(x - radius), right = column(x + radius);
    const int bottom = row(y - radius), top = row(y + radius);
    for (int r = bottom; r <= top; ++r) {
      const std::size_t row_start = static_cast<std::size_t>(r) * columns_;
      for (std::uint32_t k = first_[row_start + left]; k < first_[row_start + right + 1]; ++k) {
        const std::uint32_t j = order_[k];
        const float dx = cloud_.x[j] - x, dy = cloud_.y[j] - y, dz = cloud_.z[j] - z;
        const float distance_sq = dx * dx + dy * dy + dz * dz;
        if (distance_sq <= radius * radius) found_.push_back({distance_sq, j});
      }
    }
  }

  const Cloud& cloud_;
  float cell_;
  float x_min_ = 0.0f, y_min_ = 0.0f;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;  ///< where each cell starts in order_, row by row
  std::vector<std::uint32_t> order_;
  std::vector<Found> found_;
  float last_radius_ = 4.0f * cell_;
};

}  // namespace primitect::synthetic
