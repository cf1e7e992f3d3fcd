// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tries planes through three points each; see ground.h.
#include "core/ground.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "core/random.h"

namespace primitect {
namespace {

using Point = Eigen::Vector3f;

std::size_t countNear(const Ground& ground, const std::vector<Point>& points) {
  return std::count_if(points.begin(), points.end(), [&](const Point& point) { return ground.isNear(point); });
}

/// Least squares to the points near it.
void refit(const std::vector<Point>& points, Ground& ground) {
  Point sum = Point::Zero();
  float count = 0.0f;
  for (const Point& point : points) {
    if (ground.isNear(point)) sum += point, count += 1.0f;
  }
  if (!(count > 0.0f)) return;
  const Point mean = sum / count;
  Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
  for (const Point& point : points) {
    if (ground.isNear(point)) spread += (point - mean) * (point - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> eigen(spread);
  ground.normal = eigen.eigenvectors().col(0);
  ground.offset = ground.normal.dot(mean);
}

/// The plane through three of the points that is near most of them.
std::optional<Ground> throughMost(const std::vector<Point>& points, Random& random) {
  constexpr int kTries = 200;
  constexpr float kLeastArea = 1e-6f;  // m^2, of the parallelogram between three points
  std::optional<Ground> best;
  std::size_t most = 0;
  for (int k = 0; k < kTries; ++k) {
    const Point a = points[random.below(points.size())], b = points[random.below(points.size())],
                c = points[random.below(points.size())];
    const Point across = (b - a).cross(c - a);
    if (!(across.norm() > kLeastArea)) continue;
    const Point normal = across.normalized();
    const Ground ground{normal, normal.dot(a)};
    const std::size_t count = countNear(ground, points);
    if (count > most) most = count, best = ground;
  }
  return best;
}

Ground withMostAbove(const Ground& ground, const std::vector<Point>& points) {
  std::size_t above = 0, below = 0;
  for (const Point& point : points) {
    const float height = ground.height(point);
    above += height > kAboveGround ? 1 : 0;
    below += height < -kAboveGround ? 1 : 0;
  }
  return below > above ? ground.turnedRound() : ground;
}

}  // namespace

std::vector<Ground> findGrounds(const std::vector<Point>& points) {
  constexpr std::size_t kMost = 2, kSome = 1000, kFewest = kSome / 5;
  std::vector<Ground> grounds;
  if (points.empty()) return grounds;
  Random random(1);
  std::vector<Point> some;
  for (std::size_t k = 0; k < kSome; ++k) some.push_back(points[random.below(points.size())]);
  std::vector<Point> left = some;
  while (grounds.size() < kMost && left.size() >= kFewest) {
    std::optional<Ground> ground = throughMost(left, random);
    if (!ground || countNear(*ground, left) < kFewest) break;
    for (int k = 0; k < 2; ++k) refit(left, *ground);
    grounds.push_back(withMostAbove(*ground, some));
    const auto isNear = [&ground](const Point& point) { return ground->isNear(point); };
    left.erase(std::remove_if(left.begin(), left.end(), isNear), left.end());
  }
  return grounds;
}

}  // namespace primitect
