// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From a cylinder to a cone that may fit its points better: where a search for one begins.
#pragma once

#include "core/fit_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Of the cones that touch the cylinder along the line that the points lie around, and curve as it does there, the one
/// whose taper agrees best with the points. About the cylinder's own axis a cone would lie askew to all that was seen;
/// and from normals, whose noise turns them off a narrow arc, its axis comes out wrong. Of points all around the axis
/// there is no such line, and it is any one.
Cone tapered(const Cylinder& cylinder, const FitPoints& points);

}  // namespace primitect
