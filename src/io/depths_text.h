// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// At which depths the points of a cloud are, in words, and whether its lengths may be millimetres.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "primitect/cloud.h"

namespace primitect::io {

/// Beyond this (m) no depth camera sees.
constexpr double kMillimetres = 100.0;

/// Nearly all of the measured points are farther away.
inline bool mayBeInMillimetres(const Cloud& cloud) {
  constexpr double kNearlyAll = 0.9;
  const auto far = std::count_if(cloud.z.begin(), cloud.z.end(), [](float z) { return z > kMillimetres; });
  return cloud.valid_count > 0 && static_cast<double>(far) > kNearlyAll * cloud.valid_count;
}

/// "at depths from 2.7 m to 3.1 m", of the measured points, of which there is one at least.
inline std::string depthsText(const Cloud& cloud) {
  // NaN loses every comparison against a number that stands first.
  float nearest = INFINITY, farthest = -INFINITY;
  for (const float z : cloud.z) {
    nearest = std::min(nearest, z);
    farthest = std::max(farthest, z);
  }
  const auto text = [](float z) {
    char digits[64];
    std::snprintf(digits, sizeof(digits), std::abs(z) >= 1000.0f ? "%.0f m" : "%.4g m", z);
    return std::string(digits);
  };
  return "at depths from " + text(nearest) + " to " + text(farthest);
}

}  // namespace primitect::io
