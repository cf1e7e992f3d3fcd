// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a cylinder or a cone goes over into the next part: the shoulder of a bottle, a lid, the tube of a funnel.
#pragma once

#include "core/point_noise.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Points of the next part stay within three deviations of the noise for some way. An end where the points leave the
/// surface by two of them in the mean, steadily or by a step, is moved to where that begins; not by more than a quarter
/// of the length: then it is the whole shape that does not fit. Changes nothing of other kinds.
void endWhereItBends(const SeenPoints& points, const PointNoise& sigma, const Shape& shape, Extent& extent);

}  // namespace primitect
