// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of a tube that hold hardly any of its points.
#pragma once

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Where a tube touches a table along a line, points of the table there are as good as its own, as far as the table
/// goes. The points without those beyond either end where fewer than a quarter lie on a length of what lies on it where
/// most are; gaps between are no ends. All of fewer than 64 points.
SeenPoints withoutThinEnds(const Cylinder& cylinder, const SeenPoints& points);

}  // namespace primitect
