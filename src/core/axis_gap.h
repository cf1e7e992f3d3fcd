// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What lies along an axis beyond a wide gap.
#pragma once

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Where a surface that goes on unseen along its axis meets another one, points of that are as good as its own. The
/// finite points without those at either end that are few, less than an eighth of the largest part, and lie beyond four
/// sixteenths of the length in a row that hold hardly any, as a gap of a quarter of the length may, and one of a third
/// always does. All of fewer than 64.
SeenPoints withoutFarEnds(const Vec3& axis, SeenPoints points);

}  // namespace primitect
