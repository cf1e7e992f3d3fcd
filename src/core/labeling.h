// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which point of the whole cloud belongs to which detection.
#pragma once

#include <cstdint>
#include <vector>

#include "core/tolerance.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Labels every point with the index + 1 of the nearest detection whose surface is within the tolerance and whose
/// observed part, enlarged by it, holds the point; 0 = none, or missing.
void labelPoints(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                 std::vector<std::uint32_t>& labels);

}  // namespace primitect
