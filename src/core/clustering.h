// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Merging the candidates of many references that mean the same shape (paper, sec. II-A and "Choice of parameters").
#pragma once

#include "core/candidate.h"
#include "core/frame_memory.h"
#include "primitect/params.h"

namespace primitect {

/// The reference of `candidate` lies within `distance` (m) of the other's surface, and its normal agrees within the
/// angle (rad). Different kinds never agree, nor do shapes seen from different sides.
bool agrees(const Candidate& candidate, const Candidate& other, double distance, double angle);

/// Strongest first; equal ones keep their order.
void sortByVotes(List<Candidate>& candidates);

/// Merges by weighted average (weights: votes), or keeps the strongest of those that agree (params.clustering = nms).
/// The result is sorted by votes, strongest first; its votes are the sums. d_s in m.
void clusterCandidates(List<Candidate>& candidates, const Params& params, double scene_diameter);

}  // namespace primitect
