// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Some of many points, evenly taken: for what is a mean over all of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "primitect/primitives.h"

namespace primitect {

/// Calls use(point) for at most `most` of the points, in their order. Returns the share of the points that it was.
template <class Use>
double forEvenly(const std::vector<Vec3>& points, std::size_t most, const Use& use) {
  const std::size_t count = std::min(points.size(), most);
  for (std::size_t i = 0; i < count; ++i) use(points[i * points.size() / count]);
  return count > 0 ? static_cast<double>(count) / static_cast<double>(points.size()) : 1.0;
}

}  // namespace primitect
