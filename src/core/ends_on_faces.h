// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a cylinder or a cone ends at a face: the table that it stands on, its lid.
#pragma once

#include "primitect/primitives.h"

namespace primitect {

/// Where the two meet, noise gives points of the one to the other, and the last points before an edge are lost: the
/// face tells better where the axis ends. An end that goes on behind the plane's observed part, or beyond it, by less
/// than `reach` (m) is moved onto it; so is one that lies before it by less than six tenths of that. Changes nothing of
/// planes and spheres, nor where the axis and the normal are more than 15 deg apart: the ring where a tilted tube meets
/// a face has no one height.
void endOn(const Detection& plane, double reach, const Shape& shape, Extent& extent);

}  // namespace primitect
