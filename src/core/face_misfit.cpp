// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums over points; see face_misfit.h.
#include "core/face_misfit.h"

#include <algorithm>

namespace primitect {
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

double unevenness(const Cloud& cloud, const List<std::uint32_t>& points, const Plane& plane, const PointNoise& sigma) {
  constexpr double kOfNoise = 1.323;  // the square of a normal deviate is below in three of four cases
  constexpr double kLeast = 1e-9;     // of a plane through the sensor, which sees none
  if (points.empty()) return 0.0;
  List<double> strays;
  for (const std::uint32_t i : points) {
    const Vec3 point = cloud.point(i);
    const double away = distance(plane, point) / sigma(point), across = plane.normal.dot(point) / point.z();
    strays.push_back(away * away / std::max(across * across, kLeast));
  }
  const auto quarter = strays.begin() + static_cast<std::ptrdiff_t>(strays.size() * 3 / 4);
  std::nth_element(strays.begin(), quarter, strays.end());
  return *quarter / kOfNoise;
}

}  // namespace primitect
