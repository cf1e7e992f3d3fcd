// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// An image of a wall, of any size.
#pragma once

#include <cstdint>
#include <limits>

#include "primitect/cloud.h"

namespace primitect::test {

enum class With { points, normals };

/// A wall 1 m in front of a camera whose pixels are `pitch` apart at 1 m; every tenth row is missing.
inline Cloud wallImage(std::uint32_t width, std::uint32_t height, float pitch, With with = With::points) {
  Cloud cloud;
  cloud.reset(width, height, with == With::normals);
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      if (row % 10 == 9) continue;
      const std::size_t i = static_cast<std::size_t>(row) * width + column;
      cloud.setPoint(i, pitch * (static_cast<float>(column) - 0.5f * static_cast<float>(width)),
                     pitch * (static_cast<float>(row) - 0.5f * static_cast<float>(height)), 1.0f, {});
      if (with == With::normals) cloud.setNormal(i, 0.0f, 0.0f, -1.0f);
    }
  }
  return cloud;
}

/// Makes a point a missing one.
inline void dropPoint(std::size_t i, Cloud& cloud) {
  if (!cloud.valid(i)) return;
  cloud.x[i] = cloud.y[i] = cloud.z[i] = std::numeric_limits<float>::quiet_NaN();
  --cloud.valid_count;
}

inline std::uint32_t measuredIn(const Cloud& cloud) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) count += cloud.valid(i) ? 1 : 0;
  return count;
}

}  // namespace primitect::test
