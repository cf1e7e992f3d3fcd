// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes that run smoothly into each other: facets of one large curved surface.
#pragma once

#include <cstdint>

#include "core/frame_memory.h"
#include "core/plane_parts.h"
#include "core/sample_graph.h"
#include "core/samples.h"
#include "core/selection.h"

namespace primitect {

/// Owner of what belongs to something else than a plane.
constexpr std::uint32_t kOther = kNobody - 1;

/// The samples (rising indices) of every group of planes that are joined, one to the next, by borders along which the
/// surface runs on smoothly. owner: of each sample, the number of its plane, below `planes`, kOther or kNobody. Groups
/// of one plane are left out.
SampleParts facetGroups(const Samples& samples, const SampleGraph& graph, const List<std::uint32_t>& owner,
                        std::uint32_t planes);

}  // namespace primitect
