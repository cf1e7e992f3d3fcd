// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering what speaks for and against a chosen hypothesis, and how sure it makes us.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/frame_memory.h"
#include "core/hypothesis.h"
#include "core/sample_graph.h"
#include "primitect/evidence.h"
#include "primitect/params.h"

namespace primitect {

/// The surface at one sample goes on smoothly at the other: no step, no edge.
bool continuous(const Samples& samples, std::uint32_t a, std::uint32_t b);

/// Evidence for hypothesis `self` of a selection with these owners of the samples. All but `lead`,
/// `own_noise` and `stands`.
Evidence gatherEvidence(const Samples& samples, const SampleGraph& graph, const List<std::uint32_t>& owner,
                        std::uint32_t self, const Hypothesis& hypothesis);

/// Probability that the shape is there and of this kind, [0, 1]: logistic regression over the evidence of detections in
/// simulated scenes whose truth is known (eval/calibrate).
double confidenceOf(Kind kind, const Evidence& evidence);

/// The confidence that decides what competes, and what others end at or are a part of: not more than even chances,
/// whatever more is asked of what is reported. With 0.8 what grows more likely later would be gone early.
inline double leastWhileChoosing(const Params& params) { return std::min(params.min_confidence, 0.5); }

/// The same params with that.
inline Params whileChoosing(Params params) {
  params.min_confidence = leastWhileChoosing(params);
  return params;
}

/// Of the samples that spoke for all of a shape this share is the part's.
void takeShare(double share, Detection& part);

}  // namespace primitect
