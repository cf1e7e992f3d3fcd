// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a cone ends at its apex.
#pragma once

#include "primitect/primitives.h"

namespace primitect {

/// A tip has hardly any points, and the last of them are lost in the noise: cones would end before it. One whose narrow
/// end has a radius below `unresolved` (m) ends at its apex, as nobody could see a top so small. Changes nothing of
/// other kinds.
void endAtTip(double unresolved, const Shape& shape, Extent& extent);

}  // namespace primitect
