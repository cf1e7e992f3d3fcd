// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes that several tests look at, one stage after the other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect::test {

/// A table with a ball, a can and a pointed hat above it, one shape of each kind.
const Plane kTable = {Vec3(0, 0.2, 1.2), Vec3(0, -0.8, -0.6)};
const Sphere kBall = {Vec3(-0.25, 0.0, 1.0), 0.08};
const Cylinder kCan = {Vec3(0.05, 0.05, 0.95), Vec3(0, -0.8, -0.6), 0.05};
const Cone kHat = {Vec3(0.3, -0.1, 0.9), Vec3(0, 0.8, 0.6), 25.0 * kDegree};

/// Any of this kind is among them.
inline bool finds(const Detections& detections, Kind kind) {
  return std::any_of(detections.items.begin(), detections.items.end(),
                     [kind](const Detection& item) { return kindOf(item.shape) == kind; });
}

/// So many exact points of each, in the order of the kinds.
inline std::vector<SurfacePoint> tabletop(const std::array<int, kKindCount>& counts, Random& random) {
  return together({patchOf(kTable, counts[0], 0.5, random), patchOf(kBall, counts[1], random),
                   patchOf(kCan, counts[2], -0.1, 0.1, random), patchOf(kHat, counts[3], 0.03, 0.25, random)});
}

/// Two faces of a box that meet at a right angle, and the cone that touches both along lines through their edge.
struct TwoFaces {
  Plane front = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  Plane top = {Vec3(0, -0.1, 1.1), Vec3(0, -1, 0)};
  Cone cone = {Vec3(-0.1, -0.1, 1.0), Vec3(1, 1, 1).normalized(), std::asin(std::sqrt(1.0 / 3.0))};

  /// 200 exact points of the front, then 200 of the top.
  std::vector<SurfacePoint> points(Random& random) const {
    return together({patchOf(front, 200, 0.1, random), patchOf(top, 200, 0.1, random)});
  }
};

}  // namespace primitect::test
