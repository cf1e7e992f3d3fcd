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

}  // namespace

void proposeHypotheses(const Samples& samples, SampleGraph& graph, const std::vector<Candidate>& candidates,
                       const ProposalRules& rules, HeldGains held, std::vector<Hypothesis>& pool, Refusals& refusals) {
  constexpr float kWell = 0.4f;
  constexpr int kTries = 2;  // what so many stronger candidates could not explain, a weaker one will not
  const std::size_t needed = static_cast<std::size_t>(rules.limits.params.min_inliers);
  std::vector<int> failures(samples.size(), 0);
  std::vector<std::uint32_t> set, part;
  for (const Candidate& candidate : candidates) {
    if (held[candidate.sample] > kWell || failures[candidate.sample] >= kTries) continue;
    Hypothesis hypothesis;
    gather(samples, held, candidate, rules, hypothesis, set);
    graph.connected(set, candidate.sample, part);
    const auto unexplained = [&held](std::uint32_t i) { return held[i] < kWellExplained; };
    if (static_cast<std::size_t>(std::count_if(part.begin(), part.end(), unexplained)) < needed / 2) {
      ++refusals[Refusal::few_inliers];
    } else if (grow(samples, held, rules, part, hypothesis, refusals)) {
      hold(hypothesis, held);
      pool.push_back(std::move(hypothesis));
      continue;
    }
    for (const std::uint32_t i : part) ++failures[i];
  }
}

}  // namespace primitect
