// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The image that a cloud of one depth camera once was: filtered or shuffled clouds get it back, pixel by pixel where
// their points lie on its rays, else one like it; sparse ones a coarser one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/frame_memory.h"
#include "core/lattice.h"
#include "kernels/loops.h"
#include "primitect/cloud.h"

namespace primitect {

/// Around its points most pixels of the image are missing, or nearly so: windows would hold too few. Of images that a
/// sensor fills 0.9 of these are measured, of one thing cut out of them 0.77.
bool isSparse(const Cloud& image);

/// A cloud as an image over x/z and y/z (tangents). Keeps its memory.
class ProjectedImage {
 public:
  /// Of points that the image does not hold the place of: missing ones, and a few far aside or where no camera sees.
  static constexpr std::uint32_t kNoPixel = kernels::kNoPixel;

  /// Pixels are those of the camera, where the points lie on the lattice of its rays. Else they are as large as the
  /// points are apart, smaller where much of the view is empty; points that share their rays, like those of several
  /// frames, count once. Of two points in a pixel the image holds the nearer one, or of one surface either. False when
  /// the cloud is an image that is not sparse, when more than a few points lie beside or behind the sensor or along a
  /// line, when no reasonable size of the pixels keeps half of the points, or when it was not seen from the origin.
  bool make(const Cloud& cloud);

  /// Of the last make(). True: pixels are those of the camera.
  bool isExact() const { return exact_; }

  /// Of the last make(). False: more points hide each other, or lie aside, than a sensor at the origin would have seen.
  bool seenFromOrigin() const { return seen_from_origin_; }

  const Cloud& image() const { return image_; }
  /// Of the cloud, without missing ones.
  std::size_t pointCount() const { return points_; }
  /// Of each point of the cloud.
  const List<std::uint32_t>& pixel() const { return pixel_; }
  /// How many points of the cloud lie in pixels with each of the labels 1, 2, ..., most.
  List<std::size_t> pointsOfLabels(const std::vector<std::uint32_t>& labels, std::size_t most) const;

 private:
  /// Columns and rows over x/z and y/z.
  struct Grid {
    double left, top, width, height;  ///< tangents: where the first pixel begins, and of each
    double columns, rows;
  };
  static Grid gridOn(const Lattice& across, const Lattice& down, const kernels::ViewBounds& view);
  /// Into image_, made as large as is needed.
  void project(const Cloud& cloud, const Grid& grid);
  bool makeExact(const Cloud& cloud, const Grid& grid);
  bool isSeenBeside(std::uint32_t pixel, float depth, float behind) const;
  bool hidesMany(const Cloud& cloud, float pitch) const;

  Cloud image_;
  List<float> u_, v_;  // of all points
  List<std::uint32_t> pixel_;
  std::size_t points_ = 0;
  bool seen_from_origin_ = true, exact_ = false;
};

}  // namespace primitect
