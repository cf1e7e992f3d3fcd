// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What was selected comes apart where it leads over several things; see verification.h.
#include <algorithm>

#include "core/axis_extent.h"
#include "core/verification.h"

namespace primitect {

bool Verification::isWhole(const Segment& segment, const std::optional<Vec3>& level) const {
  const Kind kind = kindOf(segment.candidate.shape);
  return std::any_of(wholes_.begin(), wholes_.end(), [&](const Whole& whole) {
    return whole.kind == kind && whole.inliers == segment.inliers && whole.level == level;
  });
}

/// The best shape for a part of a segment; nothing where there is none. What belongs to the others (rising indices)
/// neither speaks against it nor is its own.
std::optional<Hypothesis> Verification::alone(const List<std::uint32_t>& part, const List<std::uint32_t>& others,
                                              const Segment& segment, const HeldGains& held) {
  HeldGains held_by_others = held;
  for (const std::uint32_t i : segment.inliers) held_by_others[i] = 0.0f;
  for (const std::uint32_t i : others) held_by_others[i] = 1.0f;
  Hypothesis shape = pool_[segment.hypothesis];
  if (!bestOfKinds(samples_, held_by_others, part, rules(), shape)) return std::nullopt;
  withhold(others, shape);
  return shape;
}

/// Tops of things of nearly the same height that a plane leads over become planes of their own, things of two radii
/// that a tube or cone leads over become tubes.
bool Verification::separate() {
  const HeldGains held = heldByChosen();
  const bool tops = params_.does(Step::level_tops), steps = params_.does(Step::axis_steps);
  bool any = false;
  for (const Segment& segment : segments_) {
    const Kind kind = kindOf(segment.candidate.shape);
    if (tops && kind == Kind::plane && separateTops(segment, held)) any = true;
    if (steps && hasAxis(kind) && separateSteps(segment, held)) any = true;
  }
  return any;
}

}  // namespace primitect
