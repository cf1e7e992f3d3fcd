// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A heap of things as in a bin of parts: in all poses, upon and before one another.
#pragma once

#include <cstdint>

#include "synthetic/world.h"

namespace primitect::synthetic {

/// Floor, a table (its top at kTableHeight), and on it 12 to 28 things within .12 to .25 m of its middle: balls,
/// cylinders, cups, bowls, cones, pots, boxes and up to two that are none of the four kinds; half of them turned
/// anyhow, the others standing or lying. One after the other is dropped straight down until it touches the table or one
/// of those before it; of eight places the one where it lies lowest is taken. Nothing rolls, and a corner may sink in
/// by some millimetres. World frame and camera as of clutteredTable().
World heap(std::uint64_t seed);

}  // namespace primitect::synthetic
