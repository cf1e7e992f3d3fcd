// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a shape's points tell its size: clutter that looks curved here and there leaves it open.
#pragma once

#include <cmath>

#include "core/covariance.h"
#include "primitect/primitives.h"

namespace primitect {

/// Rad. A sharper cone must still be told from a cylinder: its half angle must be known so much better as it is
/// sharper.
constexpr double kSharpCone = 10.0 * M_PI / 180.0;

/// What is left of the confidence in a shape of this uncertainty, [0, 1]: full where its points determine its radius
/// (cone: its half angle), nothing where these could be much else. Planes
/// have neither: 1.
double trustInSize(const Shape& shape, const Uncertainty& uncertainty);

}  // namespace primitect
