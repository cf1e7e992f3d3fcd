// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From one bound to another.
#pragma once

#include <algorithm>

namespace primitect {

/// 0 at `low` and before, 1 at `high` and beyond, and in between in proportion; `high` may be the smaller one.
inline double ramp(double low, double high, double value) { return std::clamp((value - low) / (high - low), 0.0, 1.0); }

}  // namespace primitect
