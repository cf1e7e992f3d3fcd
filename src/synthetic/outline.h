// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The outline of a set of pixels, and the smallest rectangle around an outline.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace primitect::synthetic {

struct Pixel {
  int u = 0;
  int v = 0;
};

/// Corners of the convex hull, counter-clockwise as one sees the image (v points down). Exact.
/// Fewer than three corners when all pixels are on one line.
std::vector<Pixel> convexHull(std::vector<Pixel> pixels);

/// A rectangle in the plane; x_axis is a unit vector along its longer side.
struct Rectangle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d x_axis = Eigen::Vector2d::UnitX();
  double size_x = 0.0;
  double size_y = 0.0;
};

/// The rectangle of smallest area around a convex outline: one of its sides lies along an edge of the outline.
Rectangle smallestRectangle(const std::vector<Eigen::Vector2d>& outline);

}  // namespace primitect::synthetic
