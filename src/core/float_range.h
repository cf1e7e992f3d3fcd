// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Least and largest of many numbers, and what lies between them in pieces.
#pragma once

#include <algorithm>
#include <cstddef>

namespace primitect {

/// Of at least one, in lanes: without branches, and without waiting for the one before.
struct FloatRange {
  float low, high;

  FloatRange(const float* values, std::size_t count) {
    constexpr std::size_t kLanes = 8;
    float least[kLanes], most[kLanes];
    std::fill_n(least, kLanes, values[0]), std::fill_n(most, kLanes, values[0]);
    std::size_t begin = 0;
    for (; begin + kLanes <= count; begin += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        least[lane] = std::min(least[lane], values[begin + lane]);
        most[lane] = std::max(most[lane], values[begin + lane]);
      }
    }
    for (; begin < count; ++begin) {
      least[0] = std::min(least[0], values[begin]), most[0] = std::max(most[0], values[begin]);
    }
    low = *std::min_element(least, least + kLanes), high = *std::max_element(most, most + kLanes);
  }
};

/// A range in so many pieces of one length.
struct EqualPieces {
  std::size_t count;
  float low, length;  ///< length: 0 where all is in one place

  EqualPieces(const FloatRange& range, std::size_t pieces)
      : count(pieces), low(range.low), length((range.high - range.low) / static_cast<float>(pieces)) {}

  std::size_t at(float value) const { return std::min(count - 1, static_cast<std::size_t>((value - low) / length)); }
  float begin(std::size_t piece) const { return low + static_cast<float>(piece) * length; }
};

}  // namespace primitect
