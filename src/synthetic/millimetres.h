// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depths as a camera's 16-bit image has them.
#pragma once

#include <cmath>
#include <cstdint>

namespace primitect::synthetic {

/// Of a depth in metres; 0 = missing, also of what 16 bits cannot say.
inline std::uint16_t millimetres(float depth) {
  const float rounded = std::round(1000.0f * depth);
  return rounded >= 1.0f && rounded <= 65535.0f ? static_cast<std::uint16_t>(rounded) : 0;
}

}  // namespace primitect::synthetic
