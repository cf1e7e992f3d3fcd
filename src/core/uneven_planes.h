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
  Plane shape;
  List<std::uint32_t> inliers;  ///< samples that nothing else explains, in rising order
  Evidence evidence = {};       ///< each sample counts for one
};

/// Planes among the samples that nothing explains yet, with twice the noise of distances and 1.5 times that of normals:
/// it is measured on what stands out clearly, mostly a table close by, and a wall 1.5 m away may wave by 5 mm. In
/// return much is asked of them: they are large, 20 cm wide, sure, little near speaks against them, and none of the
/// curved shapes that are looked for explains their samples better. Of an independent simulator's 717 walls, floors and
/// doors above 20,000 pixels, 16 were missing without them and 5 are with them, and one more plane is wrong. None
/// where all samples are noisy: on tables with twice the noise, which five pixels share, narrow planes along what is
/// round came of it. owner: of each sample, as in Selection; held: the gains of these; rules: with the noise that was
/// measured, which is a depth camera's.
List<UnevenPlane> findUnevenPlanes(const Samples& samples, SampleGraph& graph, const HeldGains& held,
                                   List<std::uint32_t> owner, const ProposalRules& rules);

}  // namespace primitect
