// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours leaf by leaf, and a walk over them; see sample_graph.h.
#include "core/sample_graph.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace primitect {
namespace {

constexpr std::size_t kLeafSize = kernels::kLeafSize;

/// A sample while parts of a set are looked for.
constexpr std::uint8_t kOutside = 0, kWaiting = 1, kReached = 2;

static_assert(SampleGraph::kNeighbors == kLeafSize);

std::size_t placeIn(double key) {
  std::int64_t bits;
  std::memcpy(&bits, &key, sizeof(bits));
  return static_cast<std::size_t>(bits & kernels::kPlaceBits);
}

kernels::NearestKeys noKeys() {
  kernels::NearestKeys keys;
  for (auto& row : keys.of) std::fill(std::begin(row), std::end(row), kernels::kNoNeighbor);
  return keys;
}

}  // namespace

void SampleGraph::build(const Samples& samples) {
  const std::size_t known = tree_.update(samples);
  keys_.resize(known);
  keys_.resize(tree_.leaves(), noKeys());
  neighbors_.resize(samples.size());
  const kernels::Loops& loops = kernels::loops();
  const kernels::LeafTree view = tree_.view();
  for (const LeafTree::Batch& batch : tree_.batches()) {
    for (std::size_t leaf = batch.first_leaf; leaf < batch.end_leaf; ++leaf) {
      const std::size_t count = batch.samplesOf(leaf);
      if (count == 0) break;
      // What was here before only looks among what is new.
      loops.nearest(view, leaf, count, leaf < known ? known : 0, tree_.leaves(), keys_[leaf]);
      store(batch.firstSampleOf(leaf), count, keys_[leaf]);
    }
  }
}

void SampleGraph::store(std::size_t first, std::size_t count, const kernels::NearestKeys& keys) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto self = static_cast<std::uint32_t>(first + i);
    for (int k = 0; k < kNeighbors; ++k) {
      const double key = keys.of[k][i];
      neighbors_[self][k] = key < kernels::kNoNeighbor ? tree_.sampleAt(placeIn(key)) : self;
    }
  }
}

void SampleGraph::mark(const List<std::uint32_t>& set) {
  state_.assign(neighbors_.size(), kOutside);
  for (const std::uint32_t i : set) state_[i] = kWaiting;
}

void SampleGraph::grow(List<std::uint32_t>& part) {
  for (std::size_t k = 0; k < part.size(); ++k) {
    for (const std::uint32_t j : neighbors_[part[k]]) {
      if (state_[j] != kWaiting) continue;
      state_[j] = kReached;
      part.push_back(j);
    }
  }
}

List<List<std::uint32_t>> SampleGraph::parts(const List<std::uint32_t>& set, std::size_t least) {
  List<List<std::uint32_t>> found;
  List<std::uint32_t> part;
  mark(set);
  for (const std::uint32_t i : set) {
    if (state_[i] != kWaiting) continue;
    state_[i] = kReached;
    part.assign(1, i);
    grow(part);
    if (part.size() < least) continue;
    std::sort(part.begin(), part.end());
    found.push_back(part);
  }
  return found;
}

List<std::uint32_t> SampleGraph::largeParts(const List<std::uint32_t>& set, std::size_t least) {
  List<std::uint32_t> large;
  for (const List<std::uint32_t>& part : parts(set, least)) large.insert(large.end(), part.begin(), part.end());
  std::sort(large.begin(), large.end());
  return large;
}

}  // namespace primitect
