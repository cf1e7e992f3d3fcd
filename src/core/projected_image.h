// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The image that an unorganized cloud of one depth camera once was: filtered or shuffled clouds get it back.
#pragma once

#include <cstdint>

#include "core/frame_memory.h"
#include "primitect/cloud.h"

namespace primitect {

/// A cloud as an image over x/z and y/z. Keeps its memory.
class ProjectedImage {
 public:
  /// Pixels as large as the points are apart, smaller where much of the view is empty; of two points in a pixel the
  /// image holds the nearer one, or of one surface the first. False when the cloud is organized, when points lie beside
  /// or behind the sensor or along a line, when no reasonable size of the pixels keeps half of the points, or when many
  /// pixels hold points of very different depth: then it was not seen from the origin.
  bool make(const Cloud& cloud);

  const Cloud& image() const { return image_; }
  /// Of each point of the cloud; of missing points: 0.
  const List<std::uint32_t>& pixel() const { return pixel_; }

 private:
  std::size_t project(const Cloud& cloud, float left, float top, float pitch);

  Cloud image_;
  List<std::uint32_t> pixel_;
};

}  // namespace primitect
