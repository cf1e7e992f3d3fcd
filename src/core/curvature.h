// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether samples lie on a curved surface at all.
#pragma once

#include "core/fitting.h"
#include "core/noise.h"

namespace primitect {

/// What tells a curved patch from a flat one.
struct Curvature {
  double turn;   ///< 1 - |mean normal|: of an arc w it is 1 - sin(w/2) / (w/2)
  double bulge;  ///< standard deviation across the plane through the points, in those of the noise
};

/// Of points with normals, none of no points; sigma: noise of their distance to a surface (m).
Curvature curvatureOf(const Moments& moments, double sigma);

/// A patch so small that all its normals are nearly one looks like a plane with noisy normals. The noise of depth
/// cameras moreover comes in waves that look like curved patches: they need a longer arc, and to rise above the noise.
bool curvesEnough(Kind kind, const Curvature& curvature, const NoiseModel& noise);

}  // namespace primitect
