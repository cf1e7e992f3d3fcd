// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How many measured points a range of depths leaves out.
#pragma once

#include <cstddef>

#include "primitect/cloud.h"
#include "primitect/depth_range.h"

namespace primitect::io {

/// Before the near bound and beyond the far one.
struct CutAway {
  std::size_t nearer = 0, farther = 0;
};

/// cloud: as it was before it was cut.
inline CutAway cutAway(const Cloud& cloud, const DepthRange& range) {
  CutAway cut;
  for (const float z : cloud.z) {
    cut.nearer += 0.0f < z && z < range.min ? 1 : 0;
    cut.farther += range.max > 0.0f && z > range.max ? 1 : 0;
  }
  return cut;
}

}  // namespace primitect::io
