// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a cylinder or a cone ends that stands on a face.
#pragma once

#include "primitect/primitives.h"

namespace primitect {

/// Where the two meet, noise gives some points of the face beside a thing to the thing, behind the face by as much as
/// the noise reaches; what is seen in front of a face does not go on behind it. An end of the axis that lies behind the
/// plane's observed part by no more than `reach` (m), while the other one lies before it, is moved onto it. Changes
/// nothing of planes and spheres, nor where the axis and the normal are more than 15 deg apart: the ring where a tilted
/// tube meets a face has no one height.
void endOn(const Detection& plane, double reach, const Shape& shape, Extent& extent);

}  // namespace primitect
