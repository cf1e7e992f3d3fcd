// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points in a plane: their convex hull, and rectangles around them.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "core/frame_memory.h"

namespace primitect {

using Vec2 = Eigen::Vector2d;

/// Convex hull, counter-clockwise (monotone chain, Andrew 1979), without corners that stand out by less than `flat`
/// (m). Points in one place have none.
List<Vec2> convexHull(const List<Vec2>& points, double flat);

/// Around points in a plane; x: direction of one side, of unit length.
struct Rectangle {
  Vec2 x, middle, size;
};

/// Around at least one point; at(k) is the k-th.
template <class PointAt>
Rectangle rectangleAlong(const Vec2& x, std::size_t count, const PointAt& at) {
  Eigen::Matrix2d axes;
  axes << x, Vec2(-x.y(), x.x());
  Vec2 low = axes.transpose() * at(0), high = low;
  for (std::size_t k = 1; k < count; ++k) {
    const Vec2 there = axes.transpose() * at(k);
    low = low.cwiseMin(there);
    high = high.cwiseMax(there);
  }
  return {x, axes * (0.5 * (low + high)), high - low};
}

inline Rectangle rectangleAlong(const Vec2& x, const List<Vec2>& points) {
  return rectangleAlong(x, points.size(), [&points](std::size_t k) { return points[k]; });
}

/// With its longer side along x. Of the smallest rectangle around a polygon one side lies along a side of the polygon
/// (Freeman and Shapira 1975). That of the largest spread of the points would lie across a square.
Rectangle smallestRectangle(const List<Vec2>& corners);

}  // namespace primitect
