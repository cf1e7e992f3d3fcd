// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A cube around most points, and a radix sort by the places of their cells; see space_curve.h.
#include "core/space_curve.h"

#include <algorithm>
#include <utility>

namespace primitect {
namespace {

constexpr int kBits = kernels::kCellBits;

}  // namespace

/// The middle nine tenths of some of the points, and as much again on either side.
kernels::CellCube SpaceCurve::cubeAround(const std::array<const List<float>*, 3>& fields) {
  constexpr std::size_t kLookedAt = 256;
  kernels::CellCube cube = {};
  float longest = 1e-9f;
  for (int axis = 0; axis < 3; ++axis) {
    const List<float>& values = *fields[axis];
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

const List<std::uint32_t>& SpaceCurve::order(const List<float>& x, const List<float>& y, const List<float>& z) {
  order_.resize(x.size());
  if (x.empty()) return order_;
  place_.resize(x.size());
  kernels::loops().places(cubeAround({&x, &y, &z}), x.data(), y.data(), z.data(), x.size(), place_.data());
  entries_.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) entries_[i] = {place_[i], static_cast<std::uint32_t>(i)};
  sortByPlace();
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = entries_[i].position;
  return order_;
}

}  // namespace primitect
