// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The transform of Skilling (Programming the Hilbert curve, AIP Conf. Proc. 707, 2004) and a radix sort.
#include "core/space_curve.h"

#include <algorithm>
#include <utility>

namespace primitect {
namespace {

constexpr int kBits = 10;  // of each coordinate

/// Spreads the lower ten bits of a number to every third bit.
std::uint32_t everyThirdBit(std::uint32_t bits) {
  bits = (bits | (bits << 16)) & 0x030000ffu;
  bits = (bits | (bits << 8)) & 0x0300f00fu;
  bits = (bits | (bits << 4)) & 0x030c30c3u;
  return (bits | (bits << 2)) & 0x09249249u;
}

/// One step down the octree: turns and mirrors what is below this bit.
void turnBelow(std::uint32_t bit, std::uint32_t& first, std::uint32_t& other) {
  const std::uint32_t below = bit - 1, swapped = (first ^ other) & below;
  const bool mirror = (other & bit) != 0;
  first ^= mirror ? below : swapped;
  other ^= mirror ? 0 : swapped;
}

std::uint32_t cellOf(float value, float low, float cells_per_meter) {
  constexpr float kLast = (1 << kBits) - 1;
  const float cell = (value - low) * cells_per_meter;
  return static_cast<std::uint32_t>(std::min(std::max(cell, 0.0f), kLast));
}

}  // namespace

std::uint32_t hilbertPlace(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
    x ^= (x & bit) != 0 ? bit - 1 : 0;
    turnBelow(bit, x, y);
    turnBelow(bit, x, z);
  }
  // Gray code: every bit says whether the next one changes.
  y ^= x, z ^= y;
  std::uint32_t above = z >> 1;
  above ^= above >> 1, above ^= above >> 2, above ^= above >> 4, above ^= above >> 8;
  return (everyThirdBit(x ^ above) << 2) | (everyThirdBit(y ^ above) << 1) | everyThirdBit(z ^ above);
}

/// The middle nine tenths of some of the points, and as much again on either side.
SpaceCurve::Cube SpaceCurve::cubeAround(const std::array<const std::vector<float>*, 3>& fields) {
  constexpr std::size_t kLookedAt = 256;
  Cube cube = {};
  float longest = 1e-9f;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<float>& values = *fields[axis];
    some_.clear();
    for (std::size_t i = 0; i < values.size(); i += values.size() / kLookedAt + 1) some_.push_back(values[i]);
    const auto low = some_.begin() + static_cast<std::ptrdiff_t>(some_.size() / 20);
    const auto high = some_.end() - 1 - static_cast<std::ptrdiff_t>(some_.size() / 20);
    std::nth_element(some_.begin(), low, some_.end());
    const float from = *low;
    std::nth_element(some_.begin(), high, some_.end());
    const float range = *high - from;
    const auto all = std::minmax_element(values.begin(), values.end());
    cube.low[axis] = std::max(*all.first, from - range);
    longest = std::max(longest, std::min(*all.second, from + 2.0f * range) - cube.low[axis]);
  }
  cube.cells_per_meter = static_cast<float>(1 << kBits) / longest;
  return cube;
}

void SpaceCurve::sortByPlace() {
  constexpr std::uint32_t kDigits = 1u << kBits;
  for (int shift = 0; shift < 3 * kBits; shift += kBits) {
    std::array<std::uint32_t, kDigits> begin = {};
    const auto digit = [shift](const Entry& entry) { return (entry.place >> shift) % kDigits; };
    for (const Entry& entry : entries_) ++begin[digit(entry)];
    std::uint32_t before = 0;
    for (std::uint32_t& count : begin) before += std::exchange(count, before);
    sorted_.resize(entries_.size());
    for (const Entry& entry : entries_) sorted_[begin[digit(entry)]++] = entry;
    entries_.swap(sorted_);
  }
}

const std::vector<std::uint32_t>& SpaceCurve::order(const std::vector<float>& x, const std::vector<float>& y,
                                                    const std::vector<float>& z) {
  order_.resize(x.size());
  if (x.empty()) return order_;
  const Cube cube = cubeAround({&x, &y, &z});
  entries_.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::uint32_t place =
        hilbertPlace(cellOf(x[i], cube.low[0], cube.cells_per_meter), cellOf(y[i], cube.low[1], cube.cells_per_meter),
                     cellOf(z[i], cube.low[2], cube.cells_per_meter));
    entries_[i] = {place, static_cast<std::uint32_t>(i)};
  }
  sortByPlace();
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = entries_[i].position;
  return order_;
}

}  // namespace primitect
