// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One pass over the cloud for each detection; see labeling.h.
#include "core/labeling.h"

#include <cmath>

#include "core/matchers.h"
#include "core/observed_part.h"

namespace primitect {

void labelPoints(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                 std::vector<std::uint32_t>& labels) {
  labels.assign(cloud.size(), 0);
  // Distance of each point to the shape whose label it has; at first what is allowed.
  std::vector<float> nearest(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    nearest[i] = static_cast<float>(tolerance.distanceAt(Vec3(cloud.x[i], cloud.y[i], cloud.z[i])));
  }
  const std::vector<float> margin = nearest;
  for (std::size_t k = 0; k < detections.size(); ++k) {
    const ObservedPart part(detections[k].shape, detections[k].extent);
    const auto labelWith = [&](const auto& shape) {
      const auto matcher = matcherOf(shape);
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        const FloatVector p = {cloud.x[i], cloud.y[i], cloud.z[i]};
        const float away = std::fabs(matcher.distanceTo(p));
        if (!(away < nearest[i]) || !part.holds(p.x, p.y, p.z, margin[i])) continue;
        nearest[i] = away;
        labels[i] = static_cast<std::uint32_t>(k + 1);
      }
    };
    std::visit(labelWith, detections[k].shape);
  }
}

}  // namespace primitect
