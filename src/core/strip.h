// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Strips of the side of a tube pass for narrow planes, lines for planes of any direction.
#pragma once

#include "core/noise.h"
#include "primitect/evidence.h"
#include "primitect/primitives.h"

namespace primitect {

/// A plane whose points lie along a line, as far as the noise can tell: any plane through it would do.
bool isLine(const Detection& detection, const NoiseModel& noise);

/// Whether a plane of this extent is much longer than wide, of whatever width.
bool isStrip(const Extent& extent);

/// What is left of the confidence in a plane of this extent, [0, 1]: nothing where it is a long strip that runs on
/// smoothly into other shapes, as what a cylinder that was fitted a little askew leaves over, more than a slat does
/// that lies flat on something. For depth cameras: with normals as poor as those of other clouds may be, planes run
/// into all that they cross.
double trustInStrip(const Extent& extent, const Evidence& evidence);

}  // namespace primitect
