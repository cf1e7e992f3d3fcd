// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Noise from the data: what strays from the shapes that the strongest candidates stand for.
#pragma once

#include <optional>

#include "core/candidate.h"
#include "core/competition.h"
#include "core/frame_memory.h"

namespace primitect {

/// Noise of clouds that no depth camera's model fits: standard deviation (m) of the distances of samples to the shapes
/// that explain the strongest candidates best, the lower quartile of these; the angle that few of their normals exceed,
/// and how many times as far they are off as their normal_sigma says, at least 1. `rules.noise` holds the largest that
/// is possible. Nothing where no candidate has enough inliers.
std::optional<NoiseModel> measureNoise(const Samples& samples, const List<Candidate>& candidates,
                                       const ProposalRules& rules);

}  // namespace primitect
