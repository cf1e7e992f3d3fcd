// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a quarter, or half, of some values lie below.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/frame_memory.h"

namespace primitect {

/// Of at least one value; their order changes.
inline double lowerQuartile(List<double>& values) {
  const auto quartile = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), quartile, values.end());
  return *quartile;
}

/// The same.
inline double median(List<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace primitect
