// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which kinds are looked for.
#pragma once

#include <cstddef>

#include "primitect/params.h"
#include "primitect/primitives.h"

namespace primitect {

inline bool isWanted(Kind kind, const Params& params) {
  const bool switches[] = {params.detect_planes, params.detect_spheres, params.detect_cylinders, params.detect_cones};
  return switches[static_cast<std::size_t>(kind)];
}

}  // namespace primitect
