// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One pass over the blocks of samples near a shape; see hypothesis.h.
#include "core/hypothesis.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>

#include "core/flat.h"
#include "core/plane_parts.h"

namespace primitect {
namespace {

static_assert(SampleBlocks::kSize == kernels::kMostGains);

/// Room for the gains of one block after the other.
struct OneBlock {
  std::array<float, SampleBlocks::kSize> gains;

  float* operator()() { return gains.data(); }
};

/// Room behind the gains of those kept so far.
struct EveryBlock {
  NearGains& near;

  float* operator()() const {
    const std::size_t kept = near.blocks.size();
    near.gains.resize(kept + 1);
    return near.gains[kept].of;
  }
};

/// Calls use(block, sums, gains) for each wanted block with samples near the shape: within `reach` times the tolerance.
template <class Room, class Wanted, class Use>
void forGains(const Samples& samples, const HeldGains& held, double widen, float reach, const Hypothesis& hypothesis,
              Room room, const Wanted& wanted, const Use& use) {
  const kernels::FlatShape shape = flattened(hypothesis.shape, Vec3::Zero());
  const kernels::JudgedSamples judged = samples.judged(held);
  const float side = hypothesis.concave ? -1.0f : 1.0f;
  const float scale = static_cast<float>(1.0 / widen);
  samples.blocks.forNear(shape, reach * static_cast<float>(widen), [&](const SampleBlock& block) {
    if (!wanted(block)) return;
    float* const gains = room();
    const kernels::GainSums sums = kernels::loops().gains(shape, side, scale, judged, block.begin, block.end, gains);
    if (sums.near > 0) use(block, sums, gains);
  });
}

/// Nothing is supported yet.
void beginSupport(const Samples& samples, Hypothesis& hypothesis) {
  hypothesis.support.clear();
  hypothesis.blocks.assign(samples.blocks.size() / 64 + 1, 0);
  hypothesis.on.assign(samples.size() / 64 + 1, 0);
  hypothesis.near.assign(samples.size() / 64 + 1, 0);
}

/// Sets those of the bits that are set, the lowest for the sample `begin`.
void mark(std::uint64_t bits, std::size_t begin, List<std::uint64_t>& all) {
  const std::size_t word = begin / 64, shift = begin % 64;
  all[word] |= bits << shift;
  if (shift > 0 && bits >> (64 - shift) != 0) all[word + 1] |= bits >> (64 - shift);
}

/// Takes the gains of a block of samples into the support, and notes the block.
void take(const float* gains, const SampleBlock& block, Hypothesis& hypothesis) {
  const std::size_t size = block.end - block.begin, before = hypothesis.support.size();
  const std::uint64_t near = kernels::loops().above(gains, size, kernels::kNoGain);
  const std::uint64_t on = kernels::loops().above(gains, size, 0.0f);
  hypothesis.support.resize(before + std::bitset<64>(near).count());
  Support* support = hypothesis.support.data() + before;
  for (std::uint64_t rest = near; rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(rest));
    *support++ = {static_cast<std::uint32_t>(block.begin + i), gains[i]};
  }
  hypothesis.blocks[block.index / 64] |= std::uint64_t{1} << block.index % 64;
  mark(on, block.begin, hypothesis.on);
  mark(near, block.begin, hypothesis.near);
}

/// Fills score, gain_sum and inliers, and calls use(block, gains) for each block with samples near the shape.
template <class Room, class Use>
void scoreWith(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis, Room room,
               const Use& use) {
  hypothesis.inliers = 0;
  hypothesis.gain_sum = 0.0;
  double counted = 0.0;
  std::size_t of_first_draw = 0;  // inliers
  const Eigen::Vector3f middle = hypothesis.middle.cast<float>();
  const auto reach = static_cast<float>(hypothesis.reach);
  const bool several_draws = samples.first_draw > 0 && kindOf(hypothesis.shape) == Kind::plane;
  // Blocks come in the order of the draws: those of the first are through by then.
  const auto drawnBeside = [&](const SampleBlock& block) {
    return several_draws && block.begin >= samples.first_draw && isLargePlane(of_first_draw, samples.first_draw);
  };
  const auto add = [&](const SampleBlock& block, const kernels::GainSums& sums, const float* gains) {
    // Something else that only happens to lie in its continuation, or beside a large plane that later draws left out.
    if (sums.counted < 0.0 && (!samples.blocks.reaches(block, middle, reach) || drawnBeside(block))) return;
    if (block.begin < samples.first_draw) of_first_draw += sums.inliers;
    hypothesis.inliers += sums.inliers;
    hypothesis.gain_sum += sums.positive;
    counted += sums.counted;
    use(block, gains);
  };
  forGains(
      samples, held, widen, samples.gain_reach, hypothesis, room, [](const SampleBlock&) { return true; }, add);
  hypothesis.score = counted - priceOf(kindOf(hypothesis.shape), static_cast<double>(hypothesis.inliers));
}

}  // namespace

double priceOf(Kind kind, double inliers) {
  constexpr int kParameters[] = {3, 4, 5, 6};
  constexpr double kPerInlier = 0.01;
  const int parameters = kParameters[static_cast<std::size_t>(kind)];
  return parameters * (std::log(std::max(inliers, 1.0)) / 9.0 + kPerInlier * inliers);
}

void score(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis) {
  scoreWith(samples, held, widen, hypothesis, OneBlock(), [](const SampleBlock&, const float*) {});
}

void score(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis, NearGains& near) {
  near.blocks.clear();
  near.gains.reserve(samples.blocks.size());
  scoreWith(samples, held, widen, hypothesis, EveryBlock{near},
            [&near](const SampleBlock& block, const float*) { near.blocks.push_back(block); });
}

void fillSupport(const Samples& samples, const NearGains& near, Hypothesis& hypothesis) {
  beginSupport(samples, hypothesis);
  for (std::size_t k = 0; k < near.blocks.size(); ++k) take(near.gains[k].of, near.blocks[k], hypothesis);
}

void evaluate(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis) {
  beginSupport(samples, hypothesis);
  scoreWith(samples, held, widen, hypothesis, OneBlock(),
            [&hypothesis](const SampleBlock& block, const float* gains) { take(gains, block, hypothesis); });
}

void inliersAround(const Vec3& point, double reach, const Samples& samples, const HeldGains& held, double widen,
                   const Hypothesis& hypothesis, List<std::uint32_t>& inliers) {
  const Eigen::Vector3f center = point.cast<float>();
  const auto radius = static_cast<float>(reach);
  const auto within = [&](const SampleBlock& block) { return samples.blocks.reaches(block, center, radius); };
  inliers.clear();
  const auto add = [&](const SampleBlock& block, const kernels::GainSums&, const float* gains) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      if (!(gains[i - block.begin] > 0.0f)) continue;
      const Eigen::Vector3f way = Eigen::Vector3f(samples.x[i], samples.y[i], samples.z[i]) - center;
      if (way.squaredNorm() <= radius * radius) inliers.push_back(static_cast<std::uint32_t>(i));
    }
  };
  constexpr float kInliers = 1.0f;
  forGains(samples, held, widen, kInliers, hypothesis, OneBlock(), within, add);
}

namespace {

bool haveCommonBits(const List<std::uint64_t>& a, const List<std::uint64_t>& b) {
  const std::size_t count = std::min(a.size(), b.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (a[k] & b[k]) return true;
  }
  return false;
}

}  // namespace

bool mayOverlap(const Hypothesis& a, const Hypothesis& b) { return haveCommonBits(a.blocks, b.blocks); }

bool concerns(const Hypothesis& other, const Hypothesis& hypothesis) {
  return mayOverlap(other, hypothesis) && haveCommonBits(other.on, hypothesis.near);
}

std::size_t commonInliers(const Hypothesis& a, const Hypothesis& b) {
  const std::size_t count = std::min(a.on.size(), b.on.size());
  std::size_t both = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (const std::uint64_t common = a.on[k] & b.on[k]) both += std::bitset<64>(common).count();
  }
  return both;
}

List<std::uint32_t> notHeld(const HeldGains& held) {
  List<std::uint32_t> rest;
  for (std::uint32_t i = 0; i < held.size(); ++i) {
    if (!(held[i] > 0.0f)) rest.push_back(i);
  }
  return rest;
}

void hold(const Hypothesis& hypothesis, HeldGains& held) {
  for (const Support& support : hypothesis.support) {
    held[support.sample] = std::max(held[support.sample], support.gain);
  }
}

void withhold(const List<std::uint32_t>& samples, Hypothesis& hypothesis) {
  List<Support>& support = hypothesis.support;
  const auto among = [&samples](const Support& at) {
    return std::binary_search(samples.begin(), samples.end(), at.sample);
  };
  support.erase(std::remove_if(support.begin(), support.end(), among), support.end());
  for (const std::uint32_t i : samples) hypothesis.on[i / 64] &= ~(std::uint64_t{1} << i % 64);
  hypothesis.gain_sum = 0.0;
  hypothesis.inliers = 0;
  for (const Support& kept : support) {
    if (!(kept.gain > 0.0f)) continue;
    hypothesis.gain_sum += kept.gain;
    ++hypothesis.inliers;
  }
}

void silence(Hypothesis& hypothesis) {
  hypothesis.support.clear();
  hypothesis.on.clear();
}

double worthAt(const List<std::uint32_t>& samples, const Hypothesis& hypothesis) {
  double gain = 0.0;
  auto next = samples.begin();
  for (const Support& support : hypothesis.support) {
    while (next != samples.end() && *next < support.sample) ++next;
    if (next != samples.end() && *next == support.sample && support.gain > 0.0f) gain += support.gain;
  }
  return gain - priceOf(kindOf(hypothesis.shape), static_cast<double>(samples.size()));
}

void inliersOf(const Hypothesis& hypothesis, List<std::uint32_t>& inliers) {
  inliers.clear();
  for (const Support& support : hypothesis.support) {
    if (support.gain > 0.0f) inliers.push_back(support.sample);
  }
}

}  // namespace primitect
