// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parts of a plane's samples that may lie in different planes.
#pragma once

#include <cstdint>
#include <optional>

#include "core/frame_memory.h"
#include "core/sample_graph.h"
#include "core/samples.h"
#include "primitect/primitives.h"

namespace primitect {

/// With that many of the first draw's samples a plane needs no closer look. Fewer than of what may support things:
/// where a wall and a floor are in view, too, a table has about a tenth, and would take half of the closer look in some
/// draws.
inline bool isLargePlane(std::size_t inliers, std::size_t samples) {
  constexpr double kLarge = 0.08;
  return static_cast<double>(inliers) > kLarge * static_cast<double>(samples);
}

/// With that many it is taken for what things stand on.
inline bool maySupport(std::size_t inliers, std::size_t samples) {
  constexpr double kOfAll = 0.1;
  return static_cast<double>(inliers) > kOfAll * static_cast<double>(samples);
}

using SampleParts = List<List<std::uint32_t>>;

/// Parts of at least `least` samples (rising indices) that do not touch; nothing when all touch.
SampleParts separateParts(const List<std::uint32_t>& inliers, std::size_t least, SampleGraph& graph);

/// Two parts of at least `least` samples at different heights, where the plane is tilted against its samples' normals:
/// it leads over a step from one surface to a parallel one. Nothing where it is not tilted.
SampleParts stepParts(const Samples& samples, const Plane& plane, const List<std::uint32_t>& inliers,
                      std::size_t least);

/// Groups of these parts of a plane, each of which lies in one plane of its own: two tops of nearly the same height,
/// which one tilted plane leads over. One group when a single plane fits all of them about as well. level: the normal
/// of what things stand on, where that was found: their tops lie as it does, so that parts at two heights (1.5
/// standard deviations of the noise and 2 mrad of the way between them apart) are rather two level tops than one tilted
/// plane where these fit better, and parts at one height are one plane.
SampleParts coplanarGroups(const Samples& samples, const SampleParts& parts,
                           const std::optional<Vec3>& level = std::nullopt);

}  // namespace primitect
