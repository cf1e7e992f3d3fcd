// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What lies along an axis beyond a wide gap.
#pragma once

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Where another surface meets the one that goes on unseen along its axis, points of the other are as good as its own.
/// The points without those at either end that are few, less than an eighth of what is left, and apart by a third of
/// the length in which there are hardly any (of pieces of a sixteenth, four). All of fewer than 64.
SeenPoints withoutFarEnds(const Vec3& axis, SeenPoints points);

}  // namespace primitect
