// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Strips of the side of a tube pass for narrow planes.
#pragma once

#include "primitect/evidence.h"
#include "primitect/primitives.h"

namespace primitect {

/// What is left of the confidence in a plane of this extent, [0, 1]: nothing where it is a long strip that runs on
/// smoothly into other shapes, as what a cylinder that was fitted a little askew leaves over, more than a slat does
/// that lies flat on something. For depth cameras: with normals as poor as those of other clouds may be, planes run
/// into all that they cross.
double trustInStrip(const Extent& extent, const Evidence& evidence);

}  // namespace primitect
