// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which samples are next to each other.
#pragma once

#include <array>
#include <cstdint>

#include "core/frame_memory.h"
#include "core/leaf_tree.h"
#include "core/samples.h"
#include "kernels/loops.h"

namespace primitect {

/// The nearest other samples of each sample.
class SampleGraph {
 public:
  static constexpr int kNeighbors = 8;
  using Neighbors = std::array<std::uint32_t, kNeighbors>;

  /// For these samples; with fewer than kNeighbors others, a sample is its own neighbour in their place. When they
  /// begin with those of the last time, only what is new is looked at. Right in any order of the samples, but only
  /// fast when neighbours in space are near each other in memory.
  void build(const Samples& samples);

  /// Nearest first; of two that are as near (squares to 1e-3 of up to 8192 samples, to twice as much of each twice as
  /// many) the one of lower index.
  const Neighbors& of(std::uint32_t sample) const { return neighbors_[sample]; }

  /// Of the samples that belongs(sample) is true of, those that can be reached from the start through others of them,
  /// in rising order. The start need not be one of them; nothing when none of its neighbours is. Asks once about each
  /// sample that it comes to.
  template <class Belongs>
  void connected(std::uint32_t start, const Belongs& belongs, List<std::uint32_t>& part);

  /// The connected parts of the set (rising indices) that have at least `least` samples, each in rising order.
  List<List<std::uint32_t>> parts(const List<std::uint32_t>& set, std::size_t least);

  /// All of these parts together, in rising order.
  List<std::uint32_t> largeParts(const List<std::uint32_t>& set, std::size_t least);

 private:
  /// A sample while parts are looked for.
  enum State : std::uint8_t { kOutside = 0, kWaiting = 1, kReached = 2, kInPart = 4 };

  /// All samples are outside.
  void forget();
  /// Adds to the part what can be reached from what is in it, and marks it.
  void grow(List<std::uint32_t>& part);
  /// Puts the part, whose samples are marked as such, in rising order; of large parts to look at all
  /// marks is faster than to sort.
  void order(List<std::uint32_t>& part) const;
  void store(std::size_t first, std::size_t count, const kernels::NearestKeys& keys);

  LeafTree tree_;
  List<kernels::NearestKeys> keys_;  ///< of each leaf
  List<Neighbors> neighbors_;
  List<std::uint8_t> state_;  ///< of each sample, and some more: they are looked at several at once
};

template <class Belongs>
void SampleGraph::connected(std::uint32_t start, const Belongs& belongs, List<std::uint32_t>& part) {
  forget();
  state_[start] = kReached;
  part.assign(1, start);
  for (std::size_t k = 0; k < part.size(); ++k) {
    for (const std::uint32_t j : neighbors_[part[k]]) {
      if (state_[j] != kOutside) continue;
      state_[j] = kReached;
      if (!belongs(j)) continue;
      state_[j] = kInPart;
      part.push_back(j);
    }
  }
  if (belongs(start)) {
    state_[start] = kInPart;
  } else {
    part.erase(part.begin());
  }
  order(part);
}

}  // namespace primitect
