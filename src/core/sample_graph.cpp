// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours leaf by leaf, and a walk over them; see sample_graph.h.
#include "core/sample_graph.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace primitect {
namespace {

using kernels::kLeafSize;

/// States that are looked at together.
constexpr std::size_t kStatesAtOnce = sizeof(std::uint64_t);

static_assert(SampleGraph::kNeighbors == kLeafSize);

std::size_t placeIn(float key, int place_bits) {
  std::int32_t bits;
  std::memcpy(&bits, &key, sizeof(bits));
  return static_cast<std::size_t>(bits & place_bits);
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
  const int place_bits = tree_.placeBits();
  for (std::size_t i = 0; i < count; ++i) {
    const auto self = static_cast<std::uint32_t>(first + i);
    for (int k = 0; k < kNeighbors; ++k) {
      const float key = keys.of[k][i];
      neighbors_[self][k] = key < kernels::kNoNeighbor ? tree_.sampleAt(placeIn(key, place_bits)) : self;
    }
  }
}

void SampleGraph::forget() {
  state_.assign((neighbors_.size() + kStatesAtOnce - 1) / kStatesAtOnce * kStatesAtOnce, kOutside);
}

void SampleGraph::grow(List<std::uint32_t>& part) {
  for (std::size_t k = 0; k < part.size(); ++k) {
    for (const std::uint32_t j : neighbors_[part[k]]) {
      if (state_[j] != kWaiting) continue;
      state_[j] = kInPart;
      part.push_back(j);
    }
  }
}

void SampleGraph::order(List<std::uint32_t>& part) const {
  constexpr std::uint64_t kMarks = kInPart * 0x0101010101010101ull;
  constexpr std::size_t kLarge = 32;  // one in so many samples; smaller parts are sorted
  if (part.size() < state_.size() / kLarge) {
    std::sort(part.begin(), part.end());
    return;
  }
  std::size_t found = 0;
  for (std::size_t first = 0; found < part.size() && first < state_.size(); first += kStatesAtOnce) {
    std::uint64_t states;
    std::memcpy(&states, state_.data() + first, kStatesAtOnce);
    if ((states & kMarks) == 0) continue;
    for (std::size_t i = first; i < first + kStatesAtOnce; ++i) {
      if (state_[i] == kInPart) part[found++] = static_cast<std::uint32_t>(i);
    }
  }
}

List<List<std::uint32_t>> SampleGraph::parts(const List<std::uint32_t>& set, std::size_t least) {
  List<List<std::uint32_t>> found;
  List<std::uint32_t> part;
  forget();
  for (const std::uint32_t i : set) state_[i] = kWaiting;
  for (const std::uint32_t i : set) {
    if (state_[i] != kWaiting) continue;
    state_[i] = kInPart;
    part.assign(1, i);
    grow(part);
    if (part.size() >= least) {
      order(part);
      found.push_back(part);
    }
    for (const std::uint32_t j : part) state_[j] = kReached;
  }
  return found;
}

List<std::uint32_t> SampleGraph::largeParts(const List<std::uint32_t>& set, std::size_t least) {
  List<std::uint32_t> large;
  for (const List<std::uint32_t>& part : parts(set, least)) large.insert(large.end(), part.begin(), part.end());
  for (const std::uint32_t i : large) state_[i] = kInPart;
  order(large);
  return large;
}

}  // namespace primitect
