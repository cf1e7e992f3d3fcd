// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The outline of the one above the other; see bent_part.h.
#include "core/bent_part.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

/// How far (m) a point lies outside of the outline of a plane, seen along its normal; below 0: inside.
double outside(const Vec3& point, const Extent& extent) {
  if (extent.hull.size() < 3) return INFINITY;
  double farthest = -INFINITY;
  for (std::size_t k = 0; k < extent.hull.size(); ++k) {
    const Vec3& corner = extent.hull[k];
    const Vec3 side = extent.hull[(k + 1) % extent.hull.size()] - corner;
    // Counter-clockwise, seen from where the normal points to.
    const Vec3 outwards = side.cross(extent.rotation.col(2));
    if (outwards.norm() > 0.0) farthest = std::max(farthest, (point - corner).dot(outwards.normalized()));
  }
  return farthest;
}

}  // namespace

bool isBentPart(const Detection& part, const Detection& whole, const NoiseModel& noise, std::uint8_t cut_off) {
  constexpr double kLarger = 4.0;  // times the points
  constexpr double kLeastTilt = 3.5 * M_PI / 180.0,
                   kMostTilt = 10.0 * M_PI / 180.0;  // what lies flat on it is not tilted
  constexpr double kMostHeight = 0.02;               // of the depth
  constexpr double kBeside = 0.01;                   // m
  const Plane *const small = std::get_if<Plane>(&part.shape), *const large = std::get_if<Plane>(&whole.shape);
  if (!small || !large || !(whole.inlier_count >= kLarger * part.inlier_count)) return false;
  if (!(part.truncated & cut_off)) return false;
  const double cosine = std::abs(small->normal.dot(large->normal));
  if (!(std::cos(kMostTilt) <= cosine && cosine <= std::cos(kLeastTilt))) return false;
  bool begins_there = false;
  for (const Vec3& corner : part.extent.hull) {
    const double height = std::abs(distance(whole.shape, corner));
    if (height > kMostHeight * corner.z()) return false;
    const bool on_it = height <= kInlierDeviations * noise.at(corner);
    begins_there = begins_there || (on_it && outside(corner, whole.extent) <= kBeside);
  }
  return begins_there;
}

}  // namespace primitect
