// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Between which depths points count.
#pragma once

namespace primitect {

struct Params;

/// Which depths count, along z of the sensor's optical frame, in metres; a bound of 0 is off.
struct DepthRange {
  float min = 0.0f;
  float max = 0.0f;

  /// Written so that NaN fails (REP 117).
  bool contains(float z) const { return (min <= 0.0f || min <= z) && (max <= 0.0f || z <= max); }

  /// A bound is less than margin (m) away from this depth, or before it.
  bool endsWithin(double margin, double z) const {
    return (max > 0.0f && z > max - margin) || (min > 0.0f && z < min + margin);
  }
};

/// Between min_depth and max_depth.
DepthRange depthRangeOf(const Params& params);

}  // namespace primitect
