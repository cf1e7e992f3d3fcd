// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering, fitting and growing; see proposal.h.
#include "core/proposal.h"

#include <algorithm>
#include <utility>

namespace primitect {

void gather(const Samples& samples, const HeldGains& held, const Candidate& candidate, const ProposalRules& rules,
            Hypothesis& hypothesis, std::vector<std::uint32_t>& set) {
  hypothesis.shape = candidate.shape;
  hypothesis.concave = candidate.concave;
  hypothesis.votes = candidate.votes;
  // A plane goes through its reference: only its direction is rough.
  const double widen = kindOf(candidate.shape) == Kind::plane ? 1.0 : rules.widen;
  inliersAround(candidate.point, rules.reach, samples, held, widen, hypothesis, set);
}

namespace {

/// Fits the hypothesis to the set, and to all that it then explains, until it grows no more; false when nothing comes
/// of it.
bool grow(const Samples& samples, const HeldGains& held, const ProposalRules& rules, std::vector<std::uint32_t> set,
          Hypothesis& hypothesis, Refusals& refusals) {
  constexpr int kGrowths = 3;
  const std::size_t needed = static_cast<std::size_t>(rules.limits.params.min_inliers);
  std::size_t before = 0;
  for (int growth = 0; growth < kGrowths && set.size() > before + before / 20; ++growth) {
    before = set.size();
    if (!bestOfKinds(samples, held, set, rules, hypothesis, &refusals)) return false;
    inliersOf(hypothesis, set);
    if (set.size() >= needed) continue;
    ++refusals[Refusal::few_inliers];
    return false;
  }
  return true;
}

/// What so many stronger candidates could not explain, a weaker one will not.
constexpr std::uint8_t kTries = 2;

}  // namespace

void Proposer::begin(HeldGains held) {
  held_ = std::move(held);
  failures_.assign(held_.size(), 0);
}

bool Proposer::wants(std::uint32_t sample) const {
  constexpr float kWell = 0.4f;
  return held_[sample] <= kWell && failures_[sample] < kTries;
}

void Proposer::propose(const Samples& samples, SampleGraph& graph, const std::vector<Candidate>& candidates,
                       const ProposalRules& rules, std::vector<Hypothesis>& pool, Refusals& refusals) {
  const std::size_t needed = static_cast<std::size_t>(rules.limits.params.min_inliers);
  const auto unexplained = [this](std::uint32_t i) { return held_[i] < kWellExplained; };
  for (const Candidate& candidate : candidates) {
    if (!wants(candidate.sample)) continue;
    Hypothesis hypothesis;
    gather(samples, held_, candidate, rules, hypothesis, set_);
    graph.connected(set_, candidate.sample, part_);
    if (static_cast<std::size_t>(std::count_if(part_.begin(), part_.end(), unexplained)) < needed / 2) {
      ++refusals[Refusal::few_inliers];
    } else if (grow(samples, held_, rules, part_, hypothesis, refusals)) {
      hold(hypothesis, held_);
      pool.push_back(std::move(hypothesis));
      continue;
    }
    for (const std::uint32_t i : part_) failures_[i] = std::min<std::uint8_t>(failures_[i] + 1, kTries);
  }
}

}  // namespace primitect
