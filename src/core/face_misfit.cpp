// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums over points; see face_misfit.h.
#include "core/face_misfit.h"

#include <algorithm>

namespace primitect {
namespace {}  // namespace

double misfit(const Cloud& cloud, const List<std::uint32_t>& points, const Plane& plane, const PointNoise& sigma) {
  constexpr double kMost = 9.0;
  double sum = 0.0;
  for (const std::uint32_t i : points) {
    const Vec3 point = cloud.point(i);
    const double away = distance(plane, point) / sigma(point);
    sum += std::min(away * away, kMost);
  }
  return sum;
}

double misfitByNoise(const Cloud& cloud, const List<std::uint32_t>& points, const Vec3& normal) {
  double sum = 0.0;
  for (const std::uint32_t i : points) {
    const double across = normal.dot(cloud.point(i)) / cloud.z[i];
    sum += across * across;
  }
  return sum;
}

}  // namespace primitect
