// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Confidence and coverage in percent, the same in tables, pictures and markers.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "primitect/primitives.h"

namespace primitect::io {

/// "97 %" of 0.973; 100 % only of 1, so that nothing looks certain that is not; "" of kUnknown.
inline std::string percentText(float share) {
  if (share == kUnknown) return "";
  const long percent = std::lround(100.0 * static_cast<double>(share));
  return std::to_string(share < 1.0f ? std::min(percent, 99L) : percent) + " %";
}

}  // namespace primitect::io
