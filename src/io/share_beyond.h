// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How much of what a camera saw the bound of its depths cuts away.
#pragma once

#include <cstddef>

#include "primitect/cloud.h"

namespace primitect::io {

/// From this share on users are told: what they look for may lie there. Of a table in a room it is about half.
constexpr double kMuchBeyond = 0.6;

/// Of the points that are measured, or say that nothing is nearer, the share beyond the far bound; 0 of no points.
inline double shareBeyond(const Cloud& cloud) {
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) beyond += cloud.isBeyond(i) ? 1 : 0;
  const std::size_t all = beyond + cloud.valid_count;
  return all > 0 ? static_cast<double>(beyond) / static_cast<double>(all) : 0.0;
}

}  // namespace primitect::io
