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

static_assert(kernels::kPointsPerRun == 64, "a bit of a word for each point");

/// Place of the set bit that has so many set ones below it.
std::uint32_t placeOf(std::uint64_t bits, std::uint32_t below) {
  constexpr std::uint64_t kOnes = 0x0101010101010101u, kTops = 0x8080808080808080u;
  // Of each byte, how many are set in it and in those below; then the first byte with more than are wanted below.
  const std::uint64_t up_to = bytesOf(bits) * kOnes, more = ((up_to | kTops) - (below + 1) * kOnes) & kTops;
  const std::uint32_t place = static_cast<std::uint32_t>(__builtin_ctzll(more)) / 8 * 8;
  below -= static_cast<std::uint32_t>(up_to << 8 >> place & 0xff);
  std::uint64_t rest = bits >> place;
  for (; below > 0; --below) rest &= rest - 1;
  return place + static_cast<std::uint32_t>(__builtin_ctzll(rest));
}

}  // namespace

void Sampler::begin(const Cloud& cloud, const PointRuns& runs) {
  cloud_ = &cloud;
  runs_ = &runs;
  left_ = runs.measured;
  free_ = left_;
}

void Sampler::keepTo(const List<std::uint64_t>& wanted) {
  free_.resize(left_.size());
  for (std::size_t k = 0; k < left_.size(); ++k) free_[k] = left_[k] & wanted[k];
}

/// One at random of each of `count` equal parts.
void Sampler::choose(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::uint64_t all = 0;
  for (const std::uint64_t bits : free_) all += countOf(bits);
  chosen_.resize(std::min<std::size_t>(count, all));
  const std::uint64_t parts = chosen_.size();
  std::size_t run = 0;
  std::uint64_t before = 0, after = parts > 0 ? countOf(free_[0]) : 0;  // free points before this run and the next
  // Part k ends at (k + 1) * all / parts, without a division for each.
  const std::uint64_t step = parts > 0 ? all / parts : 0, rest = parts > 0 ? all % parts : 0;
  std::uint64_t first = 0, end = 0, share = 0;
  for (std::uint64_t k = 0; k < parts; ++k) {
    end += step, share += rest;
    if (share >= parts) share -= parts, ++end;
    const std::uint64_t number = first + random.below(end - first);
    first = end;
    while (number >= after) before = after, after += countOf(free_[++run]);
    const std::uint32_t place = placeOf(free_[run], static_cast<std::uint32_t>(number - before));
    left_[run] &= ~(std::uint64_t{1} << place);
    chosen_[k] = static_cast<std::uint32_t>(runs_->layout.point(runs_->number[run], place));
  }
  free_ = left_;
}

void Sampler::draw(std::size_t count, std::uint64_t seed, Samples& samples) {
  choose(count, seed);
  for (List<float>* values : {&x_, &y_, &z_}) values->resize(chosen_.size());
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    const std::uint32_t index = chosen_[i];
    x_[i] = cloud_->x[index], y_[i] = cloud_->y[index], z_[i] = cloud_->z[index];
  }
  samples.clear();
  samples.resize(chosen_.size());
  std::size_t next = 0;
  for (const std::uint32_t i : curve_.order(x_, y_, z_)) {
    samples.index[next] = chosen_[i];
    samples.x[next] = samples.px[next] = x_[i];
    samples.y[next] = samples.py[next] = y_[i];
    samples.z[next] = samples.pz[next] = z_[i];
    ++next;
  }
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  for (List<float>* normal : {&samples.nx, &samples.ny, &samples.nz})
    std::fill(normal->begin(), normal->end(), kMissing);
}

void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples) {
  Sampler sampler;
  PointRuns runs;
  findRuns(cloud, runs);
  sampler.begin(cloud, runs);
  sampler.draw(count, seed, samples);
}

double boundingBoxDiagonal(const Samples& samples) {
  if (samples.size() == 0) return 0.0;
  double squares = 0.0;
  for (const List<float>* values : {&samples.x, &samples.y, &samples.z}) {
    const auto range = std::minmax_element(values->begin(), values->end());
    squares += std::pow(static_cast<double>(*range.second) - *range.first, 2);
  }
  return std::sqrt(squares);
}

}  // namespace primitect
