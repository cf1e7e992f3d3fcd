// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Stratified random draws that look only at what they draw; see sampling.h.
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

}  // namespace

void Sampler::begin(const Cloud& cloud) {
  drawn_.assign(cloud.size(), false);
  any_drawn_ = false;
}

/// One point at random of each of so many equal runs of the cloud, in its order.
void Sampler::drawFrom(const Cloud& cloud, std::size_t runs, std::uint64_t seed) {
  // Numbers of 32 bits before and 32 behind the point: no divisions.
  const std::uint64_t step = (static_cast<std::uint64_t>(cloud.size()) << 32) / runs;
  Random random(seed);
  indices_.resize(runs);
  std::uint64_t first = 0;
  for (std::size_t run = 0; run < runs; ++run) {
    const std::uint64_t end = run + 1 < runs ? ((run + 1) * step) >> 32 : cloud.size();
    indices_[run] = static_cast<std::uint32_t>(first + (((random.next() >> 32) * (end - first)) >> 32));
    first = end;
  }
}

/// Those that are there, not drawn yet and not explained.
void Sampler::keepFree(const Cloud& cloud, const ExplainedPoints& explained) {
  constexpr std::size_t kAtOnce = ExplainedPoints::kAtOnce;
  float x[kAtOnce], y[kAtOnce], z[kAtOnce];
  std::uint8_t is_explained[kAtOnce] = {};
  std::size_t kept = 0;
  for (std::size_t first = 0; first < indices_.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, indices_.size() - first);
    const std::uint32_t* const here = indices_.data() + first;
    for (std::size_t i = 0; i < count; ++i) x[i] = cloud.x[here[i]], y[i] = cloud.y[here[i]], z[i] = cloud.z[here[i]];
    if (!explained.none()) explained.find(x, y, z, count, is_explained);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t index = here[i];
      indices_[kept] = index;
      kept += z[i] == z[i] && is_explained[i] == 0 && !drawn_[index] ? 1 : 0;
    }
  }
  indices_.resize(kept);
}

void Sampler::keepEvenly(std::size_t count) {
  if (indices_.size() <= count) return;
  for (std::size_t i = 0; i < count; ++i) indices_[i] = indices_[i * indices_.size() / count];
  indices_.resize(count);
}

void Sampler::findFree(const Cloud& cloud, const ExplainedPoints& explained, std::size_t count, std::uint64_t seed) {
  constexpr double kGuess = 0.5;  // share of the points that later rounds find free, till they know
  constexpr double kSpare = 1.1;  // a few more than expected
  const auto all = static_cast<double>(cloud.size());
  indices_.clear();
  if (cloud.valid_count == 0) return;
  double share = cloud.valid_count / all * (explained.none() && !any_drawn_ ? 1.0 : kGuess);
  for (bool everything = false; indices_.size() < count && !everything;) {
    const double wanted = (share < 1.0 ? kSpare : 1.0) * static_cast<double>(count) / share;
    // Where half of them are looked at, all of them cost hardly more.
    everything = 2.0 * wanted >= all;
    drawFrom(cloud, everything ? cloud.size() : static_cast<std::size_t>(wanted), seed);
    const auto looked_at = static_cast<double>(indices_.size());
    keepFree(cloud, explained);
    share = static_cast<double>(std::max<std::size_t>(indices_.size(), 1)) / looked_at;
  }
}

void Sampler::draw(const Cloud& cloud, const ExplainedPoints& explained, std::size_t count, std::uint64_t seed,
                   Samples& samples) {
  findFree(cloud, explained, count, seed);
  keepEvenly(count);
  gather(cloud, indices_, samples);
  along_curve_.clear();
  for (const std::uint32_t i : curve_.order(samples.x, samples.y, samples.z)) along_curve_.push_back(indices_[i]);
  gather(cloud, along_curve_, samples);
  for (const std::uint32_t index : indices_) drawn_[index] = true;
  any_drawn_ = true;
}

void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples) {
  Sampler sampler;
  sampler.begin(cloud);
  sampler.draw(cloud, {}, count, seed, samples);
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
