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

/// What samples show along an axis (m).
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  double length() const { return high - low; }
};

Range rangeAlong(const Axis& axis, const List<std::uint32_t>& of_shape, const Samples& samples) {
  Range range;
  for (const std::uint32_t i : of_shape) {
    const double along = (samples.point(i) - axis.point).dot(axis.direction);
    range.low = std::min(range.low, along), range.high = std::max(range.high, along);
  }
  return range;
}

bool anyWithin(double reach, const Vec3& of, const List<std::uint32_t>& set, const Samples& samples) {
  return std::any_of(set.begin(), set.end(),
                     [&](std::uint32_t i) { return (samples.point(i) - of).squaredNorm() < reach * reach; });
}

/// radiusAt(along): of the shape, where its axis has gone so far.
template <class RadiusAt>
double standsWithAxis(const Plane& plane, const List<std::uint32_t>& of_plane, const Axis& axis,
                      const RadiusAt& radiusAt, const List<std::uint32_t>& of_shape, const Samples& samples) {
  constexpr double kUpright = 3.0 * M_PI / 180.0, kLeaning = 12.0 * M_PI / 180.0;
  constexpr double kOfLength = 0.3;
  const double upright = ramp(kLeaning, kUpright, plane.normal.cross(axis.direction).norm());
  if (upright == 0.0) return 0.0;
  const double foot = (plane.point - axis.point).dot(plane.normal) / plane.normal.dot(axis.direction);
  const Range range = rangeAlong(axis, of_shape, samples);
  const double gap = std::min(std::abs(foot - range.low), std::abs(foot - range.high));
  if (!(gap < kOfLength * range.length())) return 0.0;
  // What stands there hides the plane behind it, and samples lie apart.
  const double reach = 2.0 * radiusAt(foot) + range.length();
  return anyWithin(reach, axis.point + foot * axis.direction, of_plane, samples) ? upright : 0.0;
}

}  // namespace

double standsOn(const Plane& plane, const List<std::uint32_t>& of_plane, const Shape& shape,
                const List<std::uint32_t>& of_shape, const Samples& samples) {
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    const auto radius = [cylinder](double) { return cylinder->radius; };
    return standsWithAxis(plane, of_plane, {cylinder->point, cylinder->axis}, radius, of_shape, samples);
  }
  const Cone* cone = std::get_if<Cone>(&shape);
  if (!cone) return 0.0;
  const auto radius = [cone](double along) { return std::abs(along) * std::tan(cone->half_angle); };
  return standsWithAxis(plane, of_plane, {cone->apex, cone->axis}, radius, of_shape, samples);
}

}  // namespace primitect
