// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The pixels around a pixel of an image, and their labels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "primitect/cloud.h"

namespace primitect {

/// Columns and rows, ends excluded.
struct PixelBlock {
  std::size_t left, right, top, bottom;
};

/// The pixel and those around it, as far as they are in the image.
inline PixelBlock blockAround(const Cloud& image, std::uint32_t pixel) {
  const std::size_t column = pixel % image.width, row = pixel / image.width;
  return {column - std::min<std::size_t>(column, 1), std::min<std::size_t>(column + 2, image.width),
          row - std::min<std::size_t>(row, 1), std::min<std::size_t>(row + 2, image.height)};
}

/// Eight pixels at the same distance around any pixel of a cloud's image.
class PixelRing {
 public:
  /// radius: px.
  PixelRing(int radius, const Cloud& cloud) : cloud_(cloud), radius_(radius) {
    const int slanted = static_cast<int>(std::lround(radius * M_SQRT1_2));
    right_ = {radius, slanted, 0, -slanted, -radius, -slanted, 0, slanted};
    down_ = {0, slanted, radius, slanted, 0, -slanted, -radius, -slanted};
    for (std::size_t k = 0; k < kCount; ++k) {
      step_[k] = static_cast<std::ptrdiff_t>(down_[k]) * cloud.width + right_[k];
    }
  }

  /// Whether some have this label. labels: of all pixels.
  bool meets(std::uint32_t label, const std::uint32_t* labels, std::uint32_t pixel) const {
    if (isInside(pixel)) return someAre(label, labels + pixel);
    bool met = false;
    forAll(pixel, [&](std::size_t at) { met = met || labels[at] == label; });
    return met;
  }

  /// Whether measured ones have other labels than this; the border of the image is none of the surface, and nothing
  /// speaks against what was not measured.
  bool meetsOther(std::uint32_t label, const std::uint32_t* labels, std::uint32_t pixel) const {
    if (isInside(pixel)) {
      return std::any_of(step_.begin(), step_.end(), [&](std::ptrdiff_t step) {
        return labels[pixel + step] != label && cloud_.valid(pixel + static_cast<std::size_t>(step));
      });
    }
    bool met = false;
    forAll(pixel, [&](std::size_t at) { met = met || (labels[at] != label && cloud_.valid(at)); });
    return met;
  }

  /// Sums of the ways (m, along x and y) from those with this label to the pixel: out of the surface where it ends
  /// there.
  std::array<float, 2> wayOut(std::uint32_t label, const std::uint32_t* labels, std::uint32_t pixel) const {
    float x = 0.0f, y = 0.0f;
    forAll(pixel, [&](std::size_t at) {
      if (labels[at] == label) x += cloud_.x[pixel] - cloud_.x[at], y += cloud_.y[pixel] - cloud_.y[at];
    });
    return {x, y};
  }

  /// Whether all are in the image, were measured, and have this label.
  bool allHave(std::uint32_t label, const std::uint32_t* labels, std::uint32_t pixel) const {
    if (!isInside(pixel)) return false;
    std::uint32_t different = 0;
    for (std::size_t k = 0; k < kCount; ++k) different |= labels[pixel + step_[k]] ^ label;
    return different == 0;
  }

 private:
  static constexpr std::size_t kCount = 8;

  /// Whether all of them are in the image.
  bool isInside(std::uint32_t pixel) const {
    const int column = static_cast<int>(pixel % cloud_.width), row = static_cast<int>(pixel / cloud_.width);
    return radius_ <= std::min(column, row) && column < static_cast<int>(cloud_.width) - radius_ &&
           row < static_cast<int>(cloud_.height) - radius_;
  }

  /// Calls use(place in the cloud) for those in the image.
  template <class Use>
  void forAll(std::uint32_t pixel, const Use& use) const {
    if (isInside(pixel)) {
      for (const std::ptrdiff_t step : step_) use(pixel + static_cast<std::size_t>(step));
      return;
    }
    const int width = static_cast<int>(cloud_.width), height = static_cast<int>(cloud_.height);
    const int column = static_cast<int>(pixel % cloud_.width), row = static_cast<int>(pixel / cloud_.width);
    for (std::size_t k = 0; k < kCount; ++k) {
      const int c = column + right_[k], r = row + down_[k];
      if (0 <= c && c < width && 0 <= r && r < height) use(pixel + static_cast<std::size_t>(step_[k]));
    }
  }

  bool someAre(std::uint32_t label, const std::uint32_t* here) const {
    std::uint32_t same = 0;
    for (std::size_t k = 0; k < kCount; ++k) same |= here[step_[k]] == label ? 1u : 0u;
    return same != 0;
  }

  const Cloud& cloud_;
  int radius_;
  std::array<int, kCount> right_, down_;     ///< columns and rows
  std::array<std::ptrdiff_t, kCount> step_;  ///< places in the cloud
};

}  // namespace primitect
