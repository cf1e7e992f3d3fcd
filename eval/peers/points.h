// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points of a cloud that a peer can use, and some of them drawn at random.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.h"
#include "primitect/cloud.h"

namespace primitect::eval {

/// Points that have a position and a normal.
inline std::vector<std::uint32_t> usablePoints(const Cloud& cloud) {
  std::vector<std::uint32_t> points;
  if (!cloud.hasNormals()) return points;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i) && cloud.nx[i] == cloud.nx[i]) points.push_back(i);
  }
  return points;
}

/// `wanted` of the points, drawn without putting back; 0, or more than there are: all of them as they are.
inline std::vector<std::uint32_t> drawPoints(std::vector<std::uint32_t> points, std::size_t wanted,
                                             std::uint64_t seed) {
  if (wanted == 0 || wanted >= points.size()) return points;
  Random random(seed);
  for (std::size_t i = 0; i < wanted; ++i) std::swap(points[i], points[i + random.below(points.size() - i)]);
  points.resize(wanted);
  return points;
}

}  // namespace primitect::eval
