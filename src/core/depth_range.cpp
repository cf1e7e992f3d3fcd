// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From the parameters; see depth_range.h.
#include "primitect/depth_range.h"

#include "primitect/params.h"

namespace primitect {

DepthRange depthRangeOf(const Params& params) {
  return {static_cast<float>(params.min_depth), static_cast<float>(params.max_depth)};
}

}  // namespace primitect
