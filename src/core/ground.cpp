// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tries planes through three points each; see ground.h.
#include "core/ground.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace primitect {
namespace {

using Point = Eigen::Vector3f;

std::size_t countNear(const Ground& ground, const std::vector<Point>& points) {
  return std::count_if(points.begin(), points.end(),
                       [&](const Point& point) { return std::abs(ground.height(point)) < kNearGround; });
}

/// Least squares to the points near it.
void refit(const std::vector<Point>& points, Ground& ground) {
  Point sum = Point::Zero();
  float count = 0.0f;
  const auto isNear = [&ground](const Point& point) { return std::abs(ground.height(point)) < kNearGround; };
  for (const Point& point : points) {
    if (isNear(point)) sum += point, count += 1.0f;
  }
  if (!(count > 0.0f)) return;
  const Point mean = sum / count;
  Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
  for (const Point& point : points) {
    if (isNear(point)) spread += (point - mean) * (point - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> eigen(spread);
  ground.normal = eigen.eigenvectors().col(0);
  ground.offset = ground.normal.dot(mean);
}

}  // namespace

std::optional<Ground> findGround(const std::vector<Point>& points) {
  constexpr int kTries = 200, kSome = 1000;
  constexpr double kLeastShare = 0.33;
  if (points.empty()) return std::nullopt;
  Random random(1);
  std::vector<Point> some;
  for (int k = 0; k < kSome; ++k) some.push_back(points[random.below(points.size())]);
  std::optional<Ground> best;
  std::size_t most = 0;
  for (int k = 0; k < kTries; ++k) {
    const Point a = some[random.below(kSome)], b = some[random.below(kSome)], c = some[random.below(kSome)];
    const Point across = (b - a).cross(c - a);
    if (!(across.norm() > 1e-6f)) continue;
    const Point normal = across.normalized();
    const Ground ground{normal, normal.dot(a)};
    const std::size_t count = countNear(ground, some);
    if (count > most) most = count, best = ground;
  }
  if (static_cast<double>(most) < kLeastShare * kSome) return std::nullopt;
  for (int k = 0; k < 2; ++k) refit(some, *best);
  std::size_t above = 0, below = 0;
  for (const Point& point : some) {
    const float height = best->height(point);
    above += height > kAboveGround ? 1 : 0;
    below += height < -kAboveGround ? 1 : 0;
  }
  return below > above ? best->turnedRound() : *best;
}

}  // namespace primitect
