// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tubes of which some lengths are seen all around, and others as a line.
#pragma once

#include <cmath>
#include <initializer_list>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect::test {

/// So many points between these heights (m), all around or on one line; of a tube thicker by `thicker` (m).
struct TubePart {
  int count;
  double low, high;
  bool on_line = false;
  double thicker = 0.0;
};

inline std::vector<SurfacePoint> tubeOf(const Cylinder& tube, std::initializer_list<TubePart> parts, Random& random) {
  std::vector<SurfacePoint> points;
  for (const TubePart& part : parts) {
    const Cylinder around = {tube.point, tube.axis, tube.radius + part.thicker};
    for (int i = 0; i < part.count; ++i) {
      const double height = random.uniform(part.low, part.high), angle = random.uniform(0.0, 2.0 * M_PI);
      points.push_back(pointOn(around, height, part.on_line ? 0.0 : angle));
    }
  }
  return points;
}

}  // namespace primitect::test
