// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points in boxes of boxes, in the order that they come in: for nearest neighbours among points that are sorted along a
// curve through space, as samples are.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/frame_memory.h"
#include "core/samples.h"
#include "kernels/loops.h"

namespace primitect {

/// Samples in leaves of kernels::kLeafSize, batch by batch: a batch begins a new node.
class LeafTree {
 public:
  struct Batch {
    std::size_t first_sample, end_sample, first_leaf, end_leaf;

    std::size_t firstSampleOf(std::size_t leaf) const {
      return first_sample + (leaf - first_leaf) * kernels::kLeafSize;
    }
    /// How many; 0 of the empty leaves that fill up the last node.
    std::size_t samplesOf(std::size_t leaf) const {
      const std::size_t first = std::min(firstSampleOf(leaf), end_sample);
      return std::min(end_sample - first, kernels::kLeafSize);
    }
  };

  /// Takes the samples that are new. Forgets everything before, unless the samples begin with those that are here
  /// already. Returns how many leaves it kept.
  std::size_t update(const Samples& samples);

  const List<Batch>& batches() const { return batches_; }
  std::size_t leaves() const { return x_.size() / kernels::kLeafSize; }
  /// The sample at a place of a leaf, counted over all leaves.
  std::uint32_t sampleAt(std::size_t place) const { return sample_[place]; }
  /// Which bits of a key are the place; see kernels::NearestKeys. Keys of leaves that are kept have the same.
  int placeBits() const { return place_bits_; }
  kernels::LeafTree view() const;

 private:
  static constexpr int kFewestPlaceBits = (1 << 13) - 1;

  struct BoxList {
    std::array<List<float>, 3> low, high;

    void resize(std::size_t count);
    std::size_t size() const { return low[0].size(); }
    void include(std::size_t box, int axis, float from, float to);
    kernels::LeafBoxes view() const;
  };

  void clear();
  bool holds(const Batch& batch, const Samples& samples) const;
  void append(const Samples& samples, std::size_t first);

  List<float> x_, y_, z_;       ///< of the places
  List<std::uint32_t> sample_;  ///< of the places
  BoxList leaf_boxes_, node_boxes_;
  List<Batch> batches_;
  int place_bits_ = kFewestPlaceBits;
};

}  // namespace primitect
