// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Machined parts, drawn at random.
#pragma once

#include "core/random.h"
#include "synthetic/csg.h"

namespace primitect::synthetic {

/// A plate, a flange, a bearing block or a stepped shaft, with holes (plain, countersunk, counterbored, drilled blind),
/// bosses, domes, dimples, pockets, slots and chamfers. About 1 across, in any unit.
Csg drawPart(Random& random);

}  // namespace primitect::synthetic
