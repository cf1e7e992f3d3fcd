// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One pass over the blocks of samples near a shape; see hypothesis.h.
#include "core/hypothesis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/flat.h"

namespace primitect {
namespace {

/// Takes the gains of a block of samples into the support; returns their sum.
double take(const float* gains, const SampleBlock& block, const HeldGains& held, Hypothesis& hypothesis) {
  std::vector<Support>& support = hypothesis.support;
  const std::size_t before = support.size();
  support.resize(before + block.end - block.begin);
  Support* next = support.data() + before;
  double sum = 0.0;
  for (std::size_t i = block.begin; i < block.end; ++i) {
    const float gain = gains[i - block.begin];
    *next = {static_cast<std::uint32_t>(i), gain};
    next += gain > kernels::kNoGain ? 1 : 0;
    hypothesis.inliers += gain > 0.0f ? 1 : 0;
    sum += gain > 0.0f || (gain > kernels::kNoGain && held[i] < kWellExplained) ? gain : 0.0f;
  }
  support.resize(static_cast<std::size_t>(next - support.data()));
  return sum;
}

}  // namespace

double priceOf(Kind kind, double inliers) {
  constexpr int kParameters[] = {3, 4, 5, 6};
  constexpr double kPerInlier = 0.01;
  const int parameters = kParameters[static_cast<std::size_t>(kind)];
  return parameters * (std::log(std::max(inliers, 1.0)) / 9.0 + kPerInlier * inliers);
}

void evaluate(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis) {
  hypothesis.support.clear();
  hypothesis.inliers = 0;
  hypothesis.blocks.assign(samples.blocks.size() / 64 + 1, 0);
  const kernels::FlatShape shape = flattened(hypothesis.shape, Vec3::Zero());
  const float side = hypothesis.concave ? -1.0f : 1.0f;
  const float scale = static_cast<float>(1.0 / widen);
  std::array<float, SampleBlocks::kSize> gains;
  double sum = 0.0;
  samples.blocks.forNear(shape, static_cast<float>(widen), [&](const SampleBlock& block) {
    kernels::loops().gains(shape, side, scale, samples.judged(), block.begin, block.end, gains.data());
    const std::size_t before = hypothesis.support.size();
    sum += take(gains.data(), block, held, hypothesis);
    if (hypothesis.support.size() > before) hypothesis.blocks[block.index / 64] |= std::uint64_t{1} << block.index % 64;
  });
  hypothesis.score = sum - priceOf(kindOf(hypothesis.shape), static_cast<double>(hypothesis.inliers));
}

bool mayOverlap(const Hypothesis& a, const Hypothesis& b) {
  const std::size_t count = std::min(a.blocks.size(), b.blocks.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (a.blocks[k] & b.blocks[k]) return true;
  }
  return false;
}

void hold(const Hypothesis& hypothesis, HeldGains& held) {
  for (const Support& support : hypothesis.support) {
    held[support.sample] = std::max(held[support.sample], support.gain);
  }
}

void inliersOf(const Hypothesis& hypothesis, std::vector<std::uint32_t>& inliers) {
  inliers.clear();
  for (const Support& support : hypothesis.support) {
    if (support.gain > 0.0f) inliers.push_back(support.sample);
  }
}

}  // namespace primitect
