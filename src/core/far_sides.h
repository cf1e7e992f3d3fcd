// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points that lie near a shape where the camera cannot see it: the other side of a thin wall.
#pragma once

#include <cstdint>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Takes their label (index + 1 of a detection) from points of curved shapes that lie on the side which a camera at the
/// origin cannot see: a wall as thin as the noise is seen from inside there. Returns the labels that were taken, of
/// each point; empty when none was.
std::vector<std::uint32_t> dropFarSides(const Cloud& cloud, const std::vector<Detection>& detections,
                                        std::vector<std::uint32_t>& labels);

}  // namespace primitect
