// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Of poses in which a thing looks the same, the one nearest to that of the last frame.
#pragma once

#include "primitect/primitives.h"

namespace primitect {

/// The direction of a pose that noise may turn while the thing rests: the axis of a cylinder, which has no sign of its
/// own, and x of a plane, whose sides may be alike. Unit; of other kinds zero.
Vec3 waveringDirection(Kind kind, const Extent& extent);

/// Turns a cylinder or a plane as before: that direction in the last frame of its track, in the same frame of
/// reference; zero: unknown, nothing is done.
///
/// A cylinder is turned round where it points the other way. Of a plane x is the nearest of the directions of its
/// longer side, and where the sides differ by a quarter at most also of the shorter one. Around what has no sides, as a
/// round lid (no rectangle is more than a quarter larger than the smallest one), x stays. Origin and size are those of
/// the rectangle along x.
void turnAsBefore(Kind kind, const Vec3& before, Extent& extent);

}  // namespace primitect
