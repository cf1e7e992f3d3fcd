// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a cylinder or a cone goes over into the next part: the shoulder of a bottle, a lid, the tube of a funnel.
#pragma once

#include "core/point_noise.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Points of the next part stay within three deviations of the noise for some way. An end where the points leave the
/// surface, by two deviations along a line or by 1.5 in a step, is moved to where that begins; either end by no more
/// than a quarter of the length, and none where the distances stray all along the axis: then it is the shape that does
/// not fit. Changes nothing of other kinds, and nothing without points. Returns the share of the points between the
/// ends, 1 where none was moved.
double endWhereItBends(const SeenPoints& points, const PointNoise& sigma, const Shape& shape, Extent& extent);

}  // namespace primitect
