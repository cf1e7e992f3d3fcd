// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The pinhole camera behind an organized cloud, found from its points.
#pragma once

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Rays of the pixels, also of those without a point, and where the sensor measures at all.
struct ImageRays {
  bool known = false;  ///< false: not organized, or not seen by a pinhole camera at the origin
  /// False: columns and rows do not tell where the points are seen from the origin, not even through a poor lens or in
  /// an image turned by a quarter. They were not seen from there, or are in no order.
  bool seen_from_origin = true;
  double misfit = 0.0;  ///< px, root mean square
  double x_offset = 0.0, x_scale = 0.0, y_offset = 0.0, y_scale = 0.0;
  bool border_known = true;  ///< false: of a list's image, which ends where the list does
  int first_column = 0, last_column = -1, first_row = 0, last_row = -1;  ///< less the sensor's margin

  /// Through a pixel, with z = 1: times a depth it is the point (m).
  Vec3 through(int column, int row) const { return {x_offset + x_scale * column, y_offset + y_scale * row, 1.0}; }
  /// Column and row, not rounded, at which a point in front of the camera (m) is seen.
  Eigen::Vector2d pixelOf(const Vec3& point) const {
    return {(point.x() / point.z() - x_offset) / x_scale, (point.y() / point.z() - y_offset) / y_scale};
  }
  bool measures(int column, int row) const {
    return first_column <= column && column <= last_column && first_row <= row && row <= last_row;
  }
};

/// So much higher than wide, or as much less, pixels may be: of four rows three may be missing.
bool isOfPixels(double height_over_width);

/// How much x/z grows from column to column, and y/z from row to row; 0: not known.
struct PixelPitch {
  double u = 0.0, v = 0.0;
};

/// Of an image whose pixels lie where they should, to a twentieth of a pixel: beside a window of 15 that is nothing.
PixelPitch pitchOf(const ImageRays& rays);

/// From some hundred points by least squares; known when these fit to a third of a pixel. Not seen from the origin
/// when column or row tell less than 95 % of the variance of x/z or y/z: of images of 15 depth cameras they tell all of
/// it; where these were moved to frames on the floor below, up to 94 %.
ImageRays findRays(const Cloud& cloud);

/// Windows of an image that is coarser than those of usual cameras, 640 pixels wide, shrink with it: what is 10 cm wide
/// has fewer pixels there. Their width as a share of the usual one, at most 1.
double shareOfUsualWindows(const ImageRays& rays);

}  // namespace primitect
