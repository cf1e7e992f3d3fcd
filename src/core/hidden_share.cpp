// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// An image of the nearest points; see hidden_share.h.
#include "core/hidden_share.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace primitect {
namespace {

using Point = Eigen::Vector3f;

/// Where a point is seen (tangents), and how far away (m).
struct Ray {
  float u, v, distance;
};

}  // namespace

double hiddenShare(const std::vector<Point>& points, const Point& place, const Point& ahead) {
  constexpr std::size_t kMostLooked = 32768, kMostPixels = 4'000'000;
  constexpr float kLeastCosine = 0.5f;
  constexpr float kWide = 3.0f;   // pixels; times the distance of neighbours that fill a disc
  constexpr float kSteep = 4.0f;  // how much farther a surface may be one pixel further, in pixels
  constexpr float kFar = std::numeric_limits<float>::max();
  std::vector<Ray> rays;
  const Point right = ahead.unitOrthogonal(), down = ahead.cross(right);
  const std::size_t step = points.size() / kMostLooked + 1;
  Ray low = {kFar, kFar, 0.0f}, high = {-kFar, -kFar, 0.0f};
  Point sum = Point::Zero();
  float square = 0.0f;
  std::size_t looked = 0;
  for (std::size_t k = 0; k < points.size(); k += step, ++looked) {
    const Point way = points[k] - place;
    const float depth = ahead.dot(way), distance = way.norm();
    sum += way;
    square += way.squaredNorm();
    if (!(depth > kLeastCosine * distance)) continue;
    rays.push_back({right.dot(way) / depth, down.dot(way) / depth, distance});
    low.u = std::min(low.u, rays.back().u), low.v = std::min(low.v, rays.back().v);
    high.u = std::max(high.u, rays.back().u), high.v = std::max(high.v, rays.back().v);
  }
  if (rays.empty()) return 1.0;
  const auto count = static_cast<float>(looked);
  const float away = sum.norm() / count, spread = std::sqrt(std::max(0.0f, square / count - away * away));
  const float pixel = kWide * spread / std::sqrt(count) / away;
  const float columns = (high.u - low.u) / pixel, rows = (high.v - low.v) / pixel;
  if (!(columns * rows < static_cast<float>(kMostPixels))) return 1.0;
  const auto width = static_cast<std::size_t>(columns) + 1;
  std::vector<float> nearest(width * (static_cast<std::size_t>(rows) + 1), kFar);
  const auto nearestOf = [&](const Ray& ray) -> float& {
    return nearest[static_cast<std::size_t>((ray.v - low.v) / pixel) * width +
                   static_cast<std::size_t>((ray.u - low.u) / pixel)];
  };
  for (const Ray& ray : rays) nearestOf(ray) = std::min(nearestOf(ray), ray.distance);
  const auto hidden = [&](const Ray& ray) { return ray.distance > (1.0f + kSteep * pixel) * nearestOf(ray); };
  const std::size_t aside = looked - rays.size();
  return static_cast<double>(aside + std::count_if(rays.begin(), rays.end(), hidden)) / static_cast<double>(looked);
}

}  // namespace primitect
