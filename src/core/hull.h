// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points in a plane: their convex hull, and rectangles around them.
#pragma once

#include <Eigen/Core>

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

/// Around at least one point.
Rectangle rectangleAlong(const Vec2& x, const List<Vec2>& points);

/// With its longer side along x. Of the smallest rectangle around a polygon one side lies along a side of the polygon
/// (Freeman and Shapira 1975). That of the largest spread of the points would lie across a square.
Rectangle smallestRectangle(const List<Vec2>& corners);

}  // namespace primitect
