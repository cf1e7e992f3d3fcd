// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parameters are in degrees, where people write them.
#pragma once

#include <cmath>

namespace primitect {

constexpr double kDegree = M_PI / 180.0;  ///< rad

}  // namespace primitect
