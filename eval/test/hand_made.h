// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Small cases whose scores can be told by looking at them.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "eval/labelled_cloud.h"
#include "test/support/exact_shapes.h"

namespace primitect::eval {

using test::cloudOf;
using test::kDegree;

/// A unit vector, z tilted about x.
inline Vec3 tilted(double degrees) { return {0.0, std::sin(degrees * kDegree), std::cos(degrees * kDegree)}; }

/// (label, how often) ...
inline std::vector<int> labels(const std::vector<std::pair<int, int>>& runs) {
  std::vector<int> all;
  for (const auto& [label, count] : runs) all.insert(all.end(), count, label);
  return all;
}

/// Horizontal squares of ten points each, one above the other, a metre apart; a truth for each.
inline LabelledCloud shelves(int count) {
  LabelledCloud result;
  std::vector<test::SurfacePoint> points;
  for (int shelf = 0; shelf < count; ++shelf) {
    result.truth.push_back({Plane{Vec3(0, 0, 1.0 + shelf), Vec3::UnitZ()}});
    for (int i = 0; i < 10; ++i) {
      points.push_back({Vec3(i % 5, i / 5, 1.0 + shelf), Vec3::UnitZ()});
      result.surface.push_back(shelf);
    }
  }
  result.cloud = result.scored = cloudOf(points);
  return result;
}

}  // namespace primitect::eval
