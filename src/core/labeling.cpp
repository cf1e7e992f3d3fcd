// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One pass over the cloud; see labeling.h.
#include "core/labeling.h"

#include <cmath>

#include "core/extent.h"

namespace primitect {

void labelPoints(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                 std::vector<std::uint32_t>& labels) {
  labels.assign(cloud.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const Vec3 point(cloud.x[i], cloud.y[i], cloud.z[i]);
    const double margin = tolerance.distanceAt(point);
    double nearest = margin;
    for (std::size_t k = 0; k < detections.size(); ++k) {
      const double away = std::abs(distance(detections[k].shape, point));
      if (!(away < nearest) || !contains(detections[k].shape, detections[k].extent, point, margin)) continue;
      nearest = away;
      labels[i] = static_cast<std::uint32_t>(k + 1);
    }
  }
}

}  // namespace primitect
