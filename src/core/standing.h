// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a shape stands on a plane: what is there does, and clutter that looks like it hardly ever happens to.
#pragma once

#include "core/frame_memory.h"
#include "core/samples.h"
#include "primitect/primitives.h"

namespace primitect {

/// How far a cylinder or a cone stands on a plane, or has it for its top, [0, 1]; both with the samples that they were
/// found by. 1 where the axis is within 3 deg of the normal, has an end no farther from the plane than .3 of its
/// length, and comes to it no farther from where it was seen than its length and its width there; less as it leans, as
/// cups seem to (upright.h), nothing from 12 deg on, or where one of the others does not hold. Other kinds stand on
/// nothing: 0.
double standsOn(const Plane& plane, const List<std::uint32_t>& of_plane, const Shape& shape,
                const List<std::uint32_t>& of_shape, const Samples& samples);

}  // namespace primitect
