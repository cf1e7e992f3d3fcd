// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// All points against one shape after the other; see explained_points.h.
#include "core/explained_points.h"

#include <algorithm>
#include <cmath>

#include "core/flat.h"

namespace primitect {

ExplainedPoints::ExplainedPoints(const std::vector<Detection>& detections, const Tolerance& tolerance)
    : tolerance_(tolerance) {
  for (const Detection& detection : detections) {
    targets_.push_back({flattened(detection.shape, Vec3::Zero()), ObservedPart(detection.shape, detection.extent)});
  }
}

void ExplainedPoints::find(const float* x, const float* y, const float* z, std::size_t count,
                           std::uint8_t* explained) const {
  float allowed[kAtOnce], distance[kAtOnce];
  std::fill_n(explained, count, std::uint8_t{0});
  for (std::size_t i = 0; i < count; ++i)
    allowed[i] = static_cast<float>(tolerance_.distanceAt(Vec3(x[i], y[i], z[i])));
  for (const Target& target : targets_) {
    kernels::loops().distances(target.shape, x, y, z, count, distance);
    // Most shapes are near none of them.
    int near = 0;
    for (std::size_t i = 0; i < count; ++i) near += std::fabs(distance[i]) < allowed[i] ? 1 : 0;
    for (std::size_t i = 0; near > 0 && i < count; ++i) {
      if (!(std::fabs(distance[i]) < allowed[i])) continue;
      --near;
      if (explained[i] == 0 && target.part.holds(x[i], y[i], z[i], allowed[i])) explained[i] = 1;
    }
  }
}

}  // namespace primitect
