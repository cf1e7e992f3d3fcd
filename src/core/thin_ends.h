// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of a tube that hold hardly any of its points.
#pragma once

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Where a tube touches a table along a line, points of the table there are as good as its own, as far as the table
/// goes. The points without those at either end where a length holds fewer than a quarter of what as long a length
/// around the usual point (the median one, by how many are around it) holds; gaps between are no ends. All of fewer
/// than 64.
SeenPoints withoutThinEnds(const Cylinder& cylinder, SeenPoints points);

}  // namespace primitect
