// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the samples of one cylinder or cone step from one radius to another: cans of two sizes on each other.
#pragma once

#include "core/plane_parts.h"

namespace primitect {

/// Two parts of at least `least` samples (rising indices, as the inliers) before and after a step across the axis,
/// where the distances from the shape show one clearly: .75 standard deviations of the noise and more. A shape that is
/// tilted or tapered to fit both sides, which makes a saw's tooth of the step, hides none. Nothing where there is no
/// step, where a bend, as of a barrel, explains the distances better, and for kinds without an axis.
SampleParts axisStepParts(const Samples& samples, const Shape& shape, const List<std::uint32_t>& inliers,
                          std::size_t least);

}  // namespace primitect
