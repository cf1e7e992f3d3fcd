// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Things of a household that are made of several parts, drawn at random.
#pragma once

#include <vector>

#include "core/random.h"
#include "synthetic/clutter_objects.h"

namespace primitect::synthetic {

/// 6 to 11 things, two in three of them of several parts; see householdTable().
std::vector<Pile> drawHouseholdPiles(Random& random);

}  // namespace primitect::synthetic
