// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// An image of the nearest points; see hidden_share.h.
#include "core/hidden_share.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace primitect {
namespace {

using Point = Eigen::Vector3f;

constexpr float kNowhere = std::numeric_limits<float>::max();

/// Where a point is seen (tangents), and how far away (m).
struct Ray {
  float u, v, distance;
};

/// Of points no more than 60 deg aside.
std::vector<Ray> raysTo(const std::vector<Point>& points, const Point& place, const Point& ahead) {
  constexpr float kLeastCosine = 0.5f;
  const Point right = ahead.unitOrthogonal(), down = ahead.cross(right);
  std::vector<Ray> rays;
  for (const Point& point : points) {
    const Point way = point - place;
    const float depth = ahead.dot(way), distance = way.norm();
    if (depth > kLeastCosine * distance) rays.push_back({right.dot(way) / depth, down.dot(way) / depth, distance});
  }
  return rays;
}

/// Tangents: three times the distance of neighbours that fill a disc as large as the spread of the points.
float pixelSize(const std::vector<Point>& points, const Point& place) {
  constexpr float kWide = 3.0f;
  const auto count = static_cast<float>(points.size());
  Point sum = Point::Zero();
  for (const Point& point : points) sum += point;
  const Point middle = sum / count;
  float square = 0.0f;
  for (const Point& point : points) square += (point - middle).squaredNorm();
  return kWide * std::sqrt(square) / count / (middle - place).norm();
}

/// Of rays to points that others hide: nearer ones in the same pixel. Nothing where that would be too many pixels.
std::optional<std::size_t> countHidden(const std::vector<Ray>& rays, float pixel) {
  constexpr float kSteep = 4.0f;  // how much farther a surface may be one pixel further, in pixels
  constexpr float kMostPixels = 4e6f;
  Ray low = {kNowhere, kNowhere, 0.0f}, high = {-kNowhere, -kNowhere, 0.0f};
  for (const Ray& ray : rays) {
    low.u = std::min(low.u, ray.u), low.v = std::min(low.v, ray.v);
    high.u = std::max(high.u, ray.u), high.v = std::max(high.v, ray.v);
  }
  const float columns = (high.u - low.u) / pixel + 1.0f, rows = (high.v - low.v) / pixel + 1.0f;
  if (rays.empty() || !(columns * rows < kMostPixels)) return std::nullopt;
  const auto width = static_cast<std::size_t>(columns);
  std::vector<float> nearest(width * static_cast<std::size_t>(rows), kNowhere);
  const auto nearestTo = [&](const Ray& ray) -> float& {
    return nearest[static_cast<std::size_t>((ray.v - low.v) / pixel) * width +
                   static_cast<std::size_t>((ray.u - low.u) / pixel)];
  };
  for (const Ray& ray : rays) nearestTo(ray) = std::min(nearestTo(ray), ray.distance);
  const auto hidden = [&](const Ray& ray) { return ray.distance > (1.0f + kSteep * pixel) * nearestTo(ray); };
  return std::count_if(rays.begin(), rays.end(), hidden);
}

}  // namespace

double hiddenShare(const std::vector<Point>& points, const Point& place, const Point& ahead) {
  constexpr std::size_t kMost = 32768;
  std::vector<Point> some;
  for (std::size_t k = 0; k < points.size(); k += points.size() / kMost + 1) some.push_back(points[k]);
  const std::vector<Ray> rays = raysTo(some, place, ahead);
  const std::optional<std::size_t> hidden = countHidden(rays, pixelSize(some, place));
  return hidden ? static_cast<double>(some.size() - rays.size() + *hidden) / static_cast<double>(some.size()) : 1.0;
}

}  // namespace primitect
