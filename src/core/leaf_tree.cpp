// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Leaves and the boxes around them; see leaf_tree.h.
#include "core/leaf_tree.h"

#include <algorithm>

namespace primitect {
namespace {

using kernels::kLanes, kernels::kLeafSize;

std::size_t roundUp(std::size_t count, std::size_t unit) { return (count + unit - 1) / unit * unit; }

/// Of a batch of so many samples.
std::size_t placesFor(std::size_t count) { return roundUp(count, kLeafSize * kLanes); }

}  // namespace

void LeafTree::BoxList::resize(std::size_t count) {
  for (auto* corners : {&low, &high}) {
    for (List<float>& values : *corners) values.resize(count, kernels::kFarAway);
  }
}

void LeafTree::BoxList::include(std::size_t box, int axis, float from, float to) {
  const bool empty = low[axis][box] == kernels::kFarAway;
  low[axis][box] = std::min(low[axis][box], from);
  high[axis][box] = empty ? to : std::max(high[axis][box], to);
}

kernels::LeafBoxes LeafTree::BoxList::view() const {
  return {{low[0].data(), low[1].data(), low[2].data()}, {high[0].data(), high[1].data(), high[2].data()}};
}

kernels::LeafTree LeafTree::view() const {
  return {x_.data(), y_.data(), z_.data(), leaf_boxes_.view(), node_boxes_.view(), place_bits_};
}

void LeafTree::clear() {
  for (List<float>* values : {&x_, &y_, &z_}) values->clear();
  sample_.clear();
  batches_.clear();
  place_bits_ = kFewestPlaceBits;
  for (BoxList* boxes : {&leaf_boxes_, &node_boxes_}) boxes->resize(0);
}

/// Bit by bit: a sample has no NaN.
bool LeafTree::holds(const Batch& batch, const Samples& samples) const {
  if (batch.end_sample > samples.size()) return false;
  const auto same = [&](const List<float>& known, const List<float>& now) {
    return std::equal(now.begin() + batch.first_sample, now.begin() + batch.end_sample,
                      known.begin() + batch.first_leaf * kLeafSize);
  };
  return same(x_, samples.x) && same(y_, samples.y) && same(z_, samples.z);
}

std::size_t LeafTree::update(const Samples& samples) {
  const auto known = [&](const Batch& batch) { return holds(batch, samples); };
  if (!std::all_of(batches_.begin(), batches_.end(), known)) clear();
  const auto known_samples = [this] { return batches_.empty() ? 0 : batches_.back().end_sample; };
  const auto haveRoom = [this](std::size_t places) { return places <= static_cast<std::size_t>(place_bits_) + 1; };
  // Keys with less room for places are of no use any more.
  if (!haveRoom(x_.size() + placesFor(samples.size() - known_samples()))) clear();
  while (!haveRoom(placesFor(samples.size()))) place_bits_ = 2 * place_bits_ + 1;
  const std::size_t kept = leaves(), first = known_samples();
  if (first < samples.size()) append(samples, first);
  return kept;
}

void LeafTree::append(const Samples& samples, std::size_t first) {
  const std::size_t count = samples.size() - first, first_place = x_.size(), first_leaf = leaves();
  const std::size_t end_leaf = first_leaf + placesFor(count) / kLeafSize;
  batches_.push_back({first, samples.size(), first_leaf, end_leaf});
  leaf_boxes_.resize(end_leaf);
  node_boxes_.resize(roundUp(end_leaf / kLanes, kLanes));
  sample_.resize(end_leaf * kLeafSize, 0);
  for (std::size_t i = 0; i < count; ++i) sample_[first_place + i] = static_cast<std::uint32_t>(first + i);
  const List<float>* const from[3] = {&samples.x, &samples.y, &samples.z};
  List<float>* const to[3] = {&x_, &y_, &z_};
  for (int axis = 0; axis < 3; ++axis) {
    to[axis]->resize(end_leaf * kLeafSize, kernels::kFarAway);
    for (std::size_t i = 0; i < count; ++i) {
      const float value = (*from[axis])[first + i];
      (*to[axis])[first_place + i] = value;
      leaf_boxes_.include((first_place + i) / kLeafSize, axis, value, value);
    }
    for (std::size_t leaf = first_leaf; leaf < first_leaf + roundUp(count, kLeafSize) / kLeafSize; ++leaf) {
      node_boxes_.include(leaf / kLanes, axis, leaf_boxes_.low[axis][leaf], leaf_boxes_.high[axis][leaf]);
    }
  }
}

}  // namespace primitect
