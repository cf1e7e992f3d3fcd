// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From candidates to hypotheses: a candidate is fitted to the samples around it, and grows.
#pragma once

#include <vector>

#include "core/candidate.h"
#include "core/competition.h"
#include "core/sample_graph.h"

namespace primitect {

/// The samples that the candidate may stand for: near its shape and within reach of its reference. The hypothesis gets
/// the candidate's shape.
void gather(const Samples& samples, const HeldGains& held, const Candidate& candidate, const ProposalRules& rules,
            Hypothesis& hypothesis, std::vector<std::uint32_t>& set);

/// Adds a hypothesis for each candidate whose reference is not explained yet, in the order of votes; held: what
/// explains the samples before. The samples near the candidate's shape, within reach of its reference, are fitted with
/// all four kinds (moments, then robust least squares); the kind with the best score wins, takes all samples that it
/// fits, and competes again on these until it grows no more. Limits hold after every fit. Where two candidates failed,
/// no other is tried.
void proposeHypotheses(const Samples& samples, SampleGraph& graph, const std::vector<Candidate>& candidates,
                       const ProposalRules& rules, HeldGains held, std::vector<Hypothesis>& pool, Refusals& refusals);

}  // namespace primitect
