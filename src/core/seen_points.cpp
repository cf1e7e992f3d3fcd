// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering the points of a shape; see seen_points.h.
#include "core/seen_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace primitect {

SeenPoints::SeenPoints(const std::vector<Vec3>& points) {
  if (!points.empty()) origin = points[points.size() / 2];
  for (const Vec3& point : points) {
    const Eigen::Vector3f offset = (point - origin).cast<float>();
    x.push_back(offset.x());
    y.push_back(offset.y());
    z.push_back(offset.z());
  }
}

float rmsDistance(const Shape& shape, const SeenPoints& points) {
  constexpr std::size_t kAtOnce = 256;
  std::array<float, kAtOnce> distance;
  const kernels::FlatShape flat = flattened(shape, points.origin);
  double sum = 0.0;
  for (std::size_t begin = 0; begin < points.size(); begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, points.size() - begin);
    kernels::loops().distances(flat, points.x.data() + begin, points.y.data() + begin, points.z.data() + begin, count,
                               distance.data());
    float some[kernels::kLanes] = {};
    std::fill(distance.begin() + static_cast<std::ptrdiff_t>(count), distance.end(), 0.0f);
    for (std::size_t k = 0; k < count; k += kernels::kLanes) {
      for (std::size_t lane = 0; lane < kernels::kLanes; ++lane) some[lane] += distance[k + lane] * distance[k + lane];
    }
    for (const float of_lane : some) sum += of_lane;
  }
  return static_cast<float>(std::sqrt(sum / static_cast<double>(points.size())));
}

}  // namespace primitect
