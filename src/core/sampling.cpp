// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Stratified random draws; see sampling.h.
#include "core/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/point_runs.h"
#include "core/random.h"

namespace primitect {
namespace {

constexpr std::size_t kRun = kernels::kPointsPerRun;

/// Places alone.
void gather(const Cloud& cloud, const std::vector<std::uint32_t>& indices, Samples& samples) {
  samples.clear();
  samples.resize(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t index = indices[i];
    samples.index[i] = index;
    samples.x[i] = cloud.x[index], samples.y[i] = cloud.y[index], samples.z[i] = cloud.z[index];
  }
}

/// One at random of each of `count` equal parts.
void drawParts(const std::vector<std::uint32_t>& free, std::size_t count, Random& random,
               std::vector<std::uint32_t>& chosen) {
  const std::uint64_t all = free.size();
  chosen.resize(count);
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::uint64_t first = k * all / count, end = (k + 1) * all / count;
    chosen[k] = free[first + random.below(end - first)];
  }
}

}  // namespace

void Sampler::findFree(const Cloud& cloud, const std::vector<std::uint32_t>& runs, std::vector<std::uint32_t>* labels) {
  if (labels != nullptr) {
    for (const std::uint32_t i : drawn_) (*labels)[i] = 1;
  }
  free_.resize(runs.size() * kRun);
  std::uint32_t* const free = free_.data();
  std::size_t count = 0;
  // Without branches: every point is written, and the next one over it if it is not free.
  for (const std::uint32_t run : runs) {
    const std::size_t end = std::min((run + 1) * kRun, cloud.size());
    for (std::size_t i = run * kRun; i < end; ++i) {
      free[count] = static_cast<std::uint32_t>(i);
      count += cloud.valid(i) & (labels == nullptr || (*labels)[i] == 0) ? 1 : 0;
    }
  }
  free_.resize(count);
}

void Sampler::draw(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples) {
  Random random(seed);
  drawParts(free_, std::min(count, free_.size()), random, chosen_);
  gather(cloud, chosen_, samples);
  along_curve_.clear();
  for (const std::uint32_t i : curve_.order(samples.x, samples.y, samples.z)) along_curve_.push_back(chosen_[i]);
  gather(cloud, along_curve_, samples);
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  for (std::vector<float>* normal : {&samples.nx, &samples.ny, &samples.nz})
    std::fill(normal->begin(), normal->end(), kMissing);
  drawn_.insert(drawn_.end(), chosen_.begin(), chosen_.end());
}

void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples) {
  Sampler sampler;
  PointRuns runs;
  findRuns(cloud, runs);
  sampler.findFree(cloud, runs.number, nullptr);
  sampler.draw(cloud, count, seed, samples);
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
