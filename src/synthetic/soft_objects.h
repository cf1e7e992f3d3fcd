// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Things of a crowded table that are none of the four kinds, drawn at random.
#pragma once

#include <vector>

#include "core/random.h"
#include "synthetic/clutter_objects.h"

namespace primitect::synthetic {

/// 7 to 13 things, boxes the only ones with a shape; see shapelessTable().
std::vector<Pile> drawSoftPiles(Random& random);

}  // namespace primitect::synthetic
