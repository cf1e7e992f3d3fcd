// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What depth cameras bend lies in no single plane: of a table or wall a second one may be found across the first, a few
// millimetres or degrees off, whose points lie among the first one's.
#pragma once

#include <cstdint>

#include "core/frame_memory.h"
#include "core/noise.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Whether a plane lies among the points of another one that has no fewer: they are tilted by a few degrees at most,
/// and in its own outline, within the noise, nearly as many or more are the other's. What lies beside another plane, or
/// on it with a step as high as three standard deviations of the noise, has none of its points there. pixels: of the
/// other one in this cloud, evenly taken where they are not all.
bool isAmong(const Detection& plane, const Detection& other, const List<std::uint32_t>& pixels, const Cloud& cloud,
             const NoiseModel& noise);

}  // namespace primitect
