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
  evaluateAround(candidate.point, rules.reach, samples, held, widen, hypothesis);
  inliersOf(hypothesis, set);
  const auto far = [&](std::uint32_t i) { return (samples.point(i) - candidate.point).norm() > rules.reach; };
  set.erase(std::remove_if(set.begin(), set.end(), far), set.end());
}

void proposeHypotheses(const Samples& samples, SampleGraph& graph, const std::vector<Candidate>& candidates,
                       const ProposalRules& rules, std::vector<Hypothesis>& pool, Refusals& refusals) {
  constexpr int kGrowths = 3;
  const std::size_t needed = static_cast<std::size_t>(rules.limits.params.min_inliers);
  constexpr float kWell = 0.4f;
  HeldGains held(samples.size(), 0.0f);
  for (const Hypothesis& hypothesis : pool) hold(hypothesis, held);
  std::vector<std::uint32_t> set, part;
  for (const Candidate& candidate : candidates) {
    if (held[candidate.sample] > kWell) continue;
    Hypothesis hypothesis;
    gather(samples, held, candidate, rules, hypothesis, set);
    graph.connected(set, candidate.sample, part);
    set.swap(part);
    const auto unexplained = [&held](std::uint32_t i) { return held[i] < kWellExplained; };
    bool good = static_cast<std::size_t>(std::count_if(set.begin(), set.end(), unexplained)) >= needed / 2;
    if (!good) ++refusals[Refusal::few_inliers];
    std::size_t before = 0;
    for (int growth = 0; good && growth < kGrowths && set.size() > before + before / 20; ++growth) {
      before = set.size();
      good = bestOfKinds(samples, held, set, rules, hypothesis, &refusals);
      inliersOf(hypothesis, set);
      if (good && set.size() < needed) ++refusals[Refusal::few_inliers];
      good = good && set.size() >= needed;
    }
    if (!good) continue;
    hold(hypothesis, held);
    pool.push_back(std::move(hypothesis));
  }
}

}  // namespace primitect
