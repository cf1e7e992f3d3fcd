// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// An axis against a plane; see standing.h.
#include "core/standing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ramp.h"

namespace primitect {
namespace {

struct Axis {
  Vec3 point, direction;
};

/// Whether it meets the plane near enough to one end of what the samples show of it. All along the axis (m).
bool endsNear(const Axis& axis, double foot, const List<std::uint32_t>& of_shape, const Samples& samples) {
  constexpr double kOfLength = 0.3;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::uint32_t i : of_shape) {
    const double along = (samples.point(i) - axis.point).dot(axis.direction);
    low = std::min(low, along), high = std::max(high, along);
  }
  return std::min(std::abs(foot - low), std::abs(foot - high)) < kOfLength * (high - low);
}

/// What stands there hides the plane behind it, and samples lie apart.
bool isSeenAround(const Vec3& foot, double radius, const List<std::uint32_t>& of_plane, const Samples& samples) {
  constexpr double kMargin = 0.08;  // m
  const double reach = radius + kMargin;
  return std::any_of(of_plane.begin(), of_plane.end(),
                     [&](std::uint32_t i) { return (samples.point(i) - foot).squaredNorm() < reach * reach; });
}

double standsWithAxis(const Plane& plane, const List<std::uint32_t>& of_plane, const Axis& axis,
                      const List<std::uint32_t>& of_shape, const Samples& samples) {
  constexpr double kUpright = 3.0 * M_PI / 180.0, kLeaning = 12.0 * M_PI / 180.0;
  const double cosine = plane.normal.dot(axis.direction);
  const double upright = ramp(kLeaning, kUpright, plane.normal.cross(axis.direction).norm());
  if (upright == 0.0 || of_shape.empty()) return 0.0;
  const double along = (plane.point - axis.point).dot(plane.normal) / cosine;
  const Vec3 foot = axis.point + along * axis.direction;
  if (!endsNear(axis, along, of_shape, samples)) return 0.0;
  const Vec3 one = samples.point(of_shape[of_shape.size() / 2]);
  const double radius = (one - axis.point).cross(axis.direction).norm();
  return isSeenAround(foot, radius, of_plane, samples) ? upright : 0.0;
}

}  // namespace

double standsOn(const Plane& plane, const List<std::uint32_t>& of_plane, const Shape& shape,
                const List<std::uint32_t>& of_shape, const Samples& samples) {
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    return standsWithAxis(plane, of_plane, {cylinder->point, cylinder->axis}, of_shape, samples);
  }
  const Cone* cone = std::get_if<Cone>(&shape);
  return cone ? standsWithAxis(plane, of_plane, {cone->apex, cone->axis}, of_shape, samples) : 0.0;
}

}  // namespace primitect
