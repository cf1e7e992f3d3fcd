// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth cameras bend flat things towards the rim of their image: there a part of a table passes for a plane of its own.
#pragma once

#include <cstdint>

#include "core/noise.h"
#include "primitect/primitives.h"

namespace primitect {

/// Whether a plane is a part of another one, much larger, that the camera bends away from it: it is cut off by the
/// image, begins on the other one and leaves it by a few degrees, no farther than lens and pattern distort. Corners of
/// tables in frames of a Kinect do by 4 to 9 deg and up to 1.6 % of the depth. cut_off: bits of `truncated` that say
/// that it is cut off by the image; of a list, whose end may be that of the image, also kTruncationUnknown.
bool isBentPart(const Detection& part, const Detection& whole, const NoiseModel& noise,
                std::uint8_t cut_off = kTruncatedByImage);

}  // namespace primitect
