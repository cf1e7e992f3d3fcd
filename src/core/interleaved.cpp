// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Counts points of the one in the outline of the other; see interleaved.h.
#include "core/interleaved.h"

#include <cmath>
#include <variant>

#include "core/observed_part.h"

namespace primitect {

bool isAmong(const Detection& plane, const Detection& other, const List<std::uint32_t>& pixels, const Cloud& cloud,
             const NoiseModel& noise) {
  constexpr double kMostTilt = 6.0 * M_PI / 180.0;
  // Points of the other one for each of its own: in 205 simulated frames of tables, heaps and halls 1 to 4 for each of
  // what was found twice, at most .5 for all others.
  constexpr double kAmong = 0.8;
  const Plane *const own = std::get_if<Plane>(&plane.shape), *const large = std::get_if<Plane>(&other.shape);
  if (!own || !large || other.inlier_count < plane.inlier_count || pixels.empty()) return false;
  if (!(own->normal.dot(large->normal) > std::cos(kMostTilt))) return false;
  // Where its points are the other's, its middle is near that one; most tops of one height or another are not.
  const Vec3& middle = plane.extent.origin;
  if (std::abs(distance(other.shape, middle)) > 2.0 * kInlierDeviations * noise.at(middle)) return false;
  const ObservedPart part(plane.shape, plane.extent);
  std::size_t within = 0;
  for (const std::uint32_t i : pixels) {
    const Vec3 point = cloud.point(i);
    const bool on = std::abs(distance(plane.shape, point)) < kInlierDeviations * noise.at(point) &&
                    part.holds(cloud.x[i], cloud.y[i], cloud.z[i], 0.0f);
    within += on ? 1 : 0;
  }
  const double share = static_cast<double>(within) / static_cast<double>(pixels.size());
  return share * other.inlier_count > kAmong * plane.inlier_count;
}

}  // namespace primitect
