// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a cylinder or a cone ends at a face: the table that it stands on, its lid.
#pragma once

#include <vector>

#include "core/point_noise.h"
#include "primitect/primitives.h"

namespace primitect {

/// The reach of a face, in standard deviations of the noise: points within three count as its own, and noise has
/// scattered some of them farther.
constexpr double kReachOfFaces = 5.0;

/// Where the two meet, noise gives points of the one to the other, and the last points before an edge are lost: the
/// face tells better where the axis ends. An end that goes on behind the plane's observed part, or beyond it, by less
/// than `reach` (m) is moved onto it; so is one that lies before it by less than six tenths of that. Changes nothing of
/// planes and spheres, nor where the axis and the normal are more than 15 deg apart: the ring where a tilted tube meets
/// a face has no one height.
void endOn(const Detection& plane, double reach, const Shape& shape, Extent& extent);

/// Whether what has this extent, as its samples tell it, may stand on the plane: the axis comes to the plane's observed
/// part within 20 deg of the normal, and one of its ends is no farther from it, before or behind, than a quarter of its
/// length and `reach` (m).
bool mayStandOn(const Detection& plane, double reach, const Extent& extent);

/// Names the planes among the items on which cylinders and cones end, those that endOn() would move their ends to, of
/// several the nearest one. An end on a face counts as seen. sigma: m, noise of the distance to a surface.
void nameEndFaces(const PointNoise& sigma, std::vector<Detection>& items);

}  // namespace primitect
