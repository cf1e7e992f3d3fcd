// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a shape's points tell its size: clutter that looks curved here and there leaves it open.
#pragma once

#include "core/covariance.h"
#include "primitect/primitives.h"

namespace primitect {

/// What is left of the confidence in a shape of this uncertainty, [0, 1]: full where its points determine its radius
/// (cone: its half angle, a sharp one the better the sharper it is), nothing where these could be much else. Planes
/// have neither: 1.
double trustInSize(const Shape& shape, const Uncertainty& uncertainty);

}  // namespace primitect
