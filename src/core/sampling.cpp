// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Stratified random draws; see sampling.h.
#include "core/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"

namespace primitect {
namespace {

void gather(const Cloud& cloud, const std::vector<std::uint32_t>& indices, Samples& samples) {
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  samples.clear();
  samples.resize(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t index = indices[i];
    samples.index[i] = index;
    samples.x[i] = cloud.x[index], samples.y[i] = cloud.y[index], samples.z[i] = cloud.z[index];
  }
  for (std::vector<float>* normal : {&samples.nx, &samples.ny, &samples.nz})
    std::fill(normal->begin(), normal->end(), kMissing);
}

constexpr std::size_t kRun = 64;  // points, of which the free ones are counted together

/// Free points of [begin, end); without labels all valid ones are. Written so that it needs no branches.
std::uint32_t freeIn(const Cloud& cloud, const std::uint32_t* labels, std::size_t begin, std::size_t end) {
  const float* const z = cloud.z.data();
  std::uint32_t count = 0;
  if (labels == nullptr) {
    for (std::size_t i = begin; i < end; ++i) count += z[i] == z[i] ? 1 : 0;
  } else {
    for (std::size_t i = begin; i < end; ++i) count += (z[i] == z[i]) & (labels[i] == 0) ? 1 : 0;
  }
  return count;
}

/// Index of the free point of this rank in a run, which has more than rank.
std::uint32_t freeAt(const Cloud& cloud, const std::uint32_t* labels, std::size_t begin, std::uint32_t rank) {
  constexpr std::size_t kStride = 16;
  const auto freeFrom = [&](std::size_t from) {
    return freeIn(cloud, labels, from, std::min(from + kStride, cloud.size()));
  };
  for (std::uint32_t here = freeFrom(begin); here <= rank; here = freeFrom(begin)) {
    rank -= here;
    begin += kStride;
  }
  for (std::size_t i = begin;; ++i) {
    if (cloud.valid(i) && (labels == nullptr || labels[i] == 0) && rank-- == 0) return static_cast<std::uint32_t>(i);
  }
}

}  // namespace

void Sampler::countFree(const Cloud& cloud, const std::uint32_t* labels) {
  before_.clear();
  std::uint32_t count = 0;
  for (std::size_t run = 0; run * kRun < cloud.size(); ++run) {
    before_.push_back(count);
    count += freeIn(cloud, labels, run * kRun, std::min((run + 1) * kRun, cloud.size()));
  }
  before_.push_back(count);
}

void Sampler::drawFree(const Cloud& cloud, const std::uint32_t* labels, std::size_t count, std::uint64_t seed) {
  const std::uint64_t all = before_.back();
  Random random(seed);
  indices_.clear();
  std::size_t run = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::uint64_t first = k * all / count, end = (k + 1) * all / count;
    const auto rank = static_cast<std::uint32_t>(first + random.below(end - first));
    while (before_[run + 1] <= rank) ++run;
    indices_.push_back(freeAt(cloud, labels, run * kRun, rank - before_[run]));
  }
}

void Sampler::draw(const Cloud& cloud, std::vector<std::uint32_t>* labels, std::size_t count, std::uint64_t seed,
                   Samples& samples) {
  if (labels != nullptr) {
    for (const std::uint32_t i : drawn_) (*labels)[i] = 1;
  }
  const std::uint32_t* const label = labels != nullptr ? labels->data() : nullptr;
  countFree(cloud, label);
  drawFree(cloud, label, std::min<std::size_t>(count, before_.back()), seed);
  gather(cloud, indices_, samples);
  along_curve_.clear();
  for (const std::uint32_t i : curve_.order(samples.x, samples.y, samples.z)) along_curve_.push_back(indices_[i]);
  gather(cloud, along_curve_, samples);
  drawn_.insert(drawn_.end(), indices_.begin(), indices_.end());
}

void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples) {
  Sampler sampler;
  sampler.draw(cloud, nullptr, count, seed, samples);
}

double boundingBoxDiagonal(const Samples& samples) {
  if (samples.size() == 0) return 0.0;
  double squares = 0.0;
  for (const std::vector<float>* values : {&samples.x, &samples.y, &samples.z}) {
    const auto range = std::minmax_element(values->begin(), values->end());
    squares += std::pow(static_cast<double>(*range.second) - *range.first, 2);
  }
  return std::sqrt(squares);
}

}  // namespace primitect
