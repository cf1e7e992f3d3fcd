// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What scenes are drawn with, besides what Random has.
#pragma once

#include "core/random.h"

namespace primitect::synthetic {

/// True in one of `count` draws.
inline bool oneIn(int count, Random& random) { return random.below(count) == 0; }

}  // namespace primitect::synthetic
