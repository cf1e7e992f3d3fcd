// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Large planes that are less even than what is near: far walls and floors, which a depth camera bends.
#pragma once

#include <cstdint>

#include "core/competition.h"
#include "core/frame_memory.h"
#include "core/sample_graph.h"
#include "primitect/evidence.h"

namespace primitect {

struct UnevenPlane {
  Hypothesis hypothesis;
  List<std::uint32_t> inliers;  ///< samples that nothing else explains, in rising order
  Evidence evidence;
  double confidence = 0.0;
};

/// Planes among the samples that nothing explains yet, with twice the noise: the noise is measured on what stands out
/// clearly, mostly a table close by, and a wall 1.5 m away may wave by 5 mm. In return much is asked of them: they are
/// large and wide, hardly anything near speaks against them, and no curved shape explains these samples better; of
/// smaller ones, insides of buckets, cloths, and steps from a skirting to its wall come out. None where all samples are
/// noisy: on tables with twice the noise, which five pixels share, that brought narrow planes along what is round.
/// owner: of each sample, as in Selection; held: the gains of these; rules: with the noise that was measured, which is
/// a depth camera's.
List<UnevenPlane> findUnevenPlanes(const Samples& samples, SampleGraph& graph, const HeldGains& held,
                                   List<std::uint32_t> owner, const ProposalRules& rules);

}  // namespace primitect
