// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The things of a crowded table, drawn at random.
#pragma once

#include <vector>

#include "core/random.h"
#include "synthetic/tabletop_objects.h"

namespace primitect::synthetic {

/// Things, or parts of one, that stand or lie together: [0] on the table, its stadium holds all of them.
using Pile = std::vector<Object>;

/// One thing that is none of the four kinds: ellipsoid, torus or lump.
Object drawShapeless(Random& random);

/// A box on the table.
Object drawBox(Random& random);

/// A ball, cylinder, cup, bowl, cone, pot or box, standing or lying.
Object drawPrimitive(Random& random);

/// 6 to 14 things, 1 to 3 of them none of the four kinds.
std::vector<Pile> drawPiles(Random& random);

}  // namespace primitect::synthetic
