// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From candidates to hypotheses: a candidate is fitted to the samples around it, and grows.
#pragma once

#include "core/candidate.h"
#include "core/competition.h"
#include "core/frame_memory.h"
#include "core/sample_graph.h"

namespace primitect {

/// The samples that the candidate may stand for: near its shape and within reach of its reference. The hypothesis gets
/// the candidate's shape.
void gather(const Samples& samples, const HeldGains& held, const Candidate& candidate, const ProposalRules& rules,
            Hypothesis& hypothesis, List<std::uint32_t>& set);

/// Makes hypotheses of candidates whose references are not explained yet. The samples near the candidate's shape,
/// within reach of its reference, are fitted with all four kinds that moments promise (then by robust least squares);
/// the kind with the best score wins, takes all samples that it fits, and competes again on these if it grew. Limits
/// hold after every fit. What grows into a hypothesis that is known is dropped, but its samples count as explained.
/// In frames of a depth camera what hides the middle of a thing may leave flat parts: where votes for a ball, tube or
/// cone lead to none, it may grow from all that lies around, too. Where two candidates failed, no other is tried.
class Proposer {
 public:
  /// Starts with what explains the samples already.
  void begin(HeldGains held);

  /// Whether a candidate of this reference would be looked at.
  bool wants(std::uint32_t sample) const;

  /// Adds to the pool what comes of the candidates, in their order.
  void propose(const Samples& samples, SampleGraph& graph, const List<Candidate>& candidates,
               const ProposalRules& rules, List<Hypothesis>& pool, Refusals& refusals);

 private:
  HeldGains held_;
  List<std::uint8_t> failures_;  ///< of each sample: candidates that came to nothing there
  List<std::uint32_t> part_;
};

}  // namespace primitect
