// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Heights of points along an axis; see axis_extent.h.
#include "core/axis_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/frame_around.h"
#include "core/frame_memory.h"

namespace primitect {
namespace {

/// For the mean, and the ends, where 1 % of the points lie beyond: 20 of these. Prime: the step through the points is
/// then seldom in time with the rows of an image.
constexpr std::size_t kMostExtentPoints = 2039;

/// Where along point + t * axis the inliers lie.
struct AxisRange {
  double low, high;
};

/// Of all inliers, not of some alone: the tip of a cone is a pixel or two. Along the axis, m; of at least one.
struct OutermostHeights {
  double low, next, high;  ///< next: the second lowest

  OutermostHeights(const Vec3& point, const Vec3& axis, const SeenPoints& inliers) {
    List<float> heights(inliers.size());
    heightsAlong(axis, inliers.x.data(), inliers.y.data(), inliers.z.data(), inliers.size(), heights.data());
    float lowest = heights.front(), second = std::numeric_limits<float>::infinity(), highest = lowest;
    for (std::size_t k = 1; k < heights.size(); ++k) {
      second = std::min(second, std::max(lowest, heights[k]));
      lowest = std::min(lowest, heights[k]);
      highest = std::max(highest, heights[k]);
    }
    const double origin = (inliers.origin - point).dot(axis);
    low = origin + lowest, next = origin + std::min(second, highest), high = origin + highest;
  }
};

/// How the surface between two heights along an axis grows with them: of a cylinder as their difference, of a cone,
/// from its apex, as that of their squares.
enum class Surface { even, tapered };

double areaUpTo(double height, Surface surface) {
  return surface == Surface::even ? height : height * std::abs(height);
}
double heightOf(double area, Surface surface) {
  return surface == Surface::even ? area : std::copysign(std::sqrt(std::abs(area)), area);
}

/// The end, from the heights that one and two hundredths of the points lie beyond: there is as much surface once more,
/// on an end that is cut askew up to three times as much as evenly. What is more are stragglers. all: height of the
/// other end.
double endFrom(double one, double two, double all, Surface surface) {
  constexpr double kMost = 0.03;  // of the surface
  const double most = kMost * std::abs(areaUpTo(all, surface) - areaUpTo(one, surface));
  const double more = std::clamp(areaUpTo(one, surface) - areaUpTo(two, surface), -most, most);
  return heightOf(areaUpTo(one, surface) + more, surface);
}

/// The narrow end of a cone (heights from its apex): one that may be its tip, as far as so few points tell, whose
/// number has a deviation of its root, lies at the outermost point, at the next one where the outermost is a straggler;
/// any other at `end`. one, two: heights that one and two hundredths of the points, `few` each, lie beyond.
double narrowEnd(double end, const OutermostHeights& outermost, double one, double two, std::size_t few) {
  constexpr double kDeviations = 2.0, kStraggler = 4.0;  // times the surface that there is for each point
  if (few == 0) return std::max(outermost.low, end);
  const auto areaOf = [](double height) { return areaUpTo(height, Surface::tapered); };
  const double hundredth = areaOf(two) - areaOf(one), count = static_cast<double>(few);
  if (areaOf(end) >= kDeviations * std::sqrt(2.0 / count) * hundredth) return std::max(outermost.low, end);
  const bool strays = areaOf(outermost.next) - areaOf(outermost.low) > kStraggler * hundredth / count;
  return strays ? outermost.next : outermost.low;
}

AxisRange rangeAlong(const Vec3& point, const Vec3& axis, const SeenPoints& all,
                     const SomePoints<kMostExtentPoints>& inliers, Surface surface, Ends ends) {
  constexpr double kStragglers = 0.01;
  float heights[SomePoints<kMostExtentPoints>::kRoom];
  heightsAlong(axis, inliers.x, inliers.y, inliers.z, inliers.count, heights);
  const auto few = static_cast<std::size_t>(kStragglers * static_cast<double>(inliers.count));
  float *const end = heights + inliers.count, *const low = heights + few, *const high = end - 1 - few;
  const double origin = (inliers.origin - point).dot(axis);
  std::nth_element(heights, low, end);
  const double from = origin + *low;
  std::nth_element(low, high, end);
  const double to = origin + *high;
  if (ends == Ends::without_stragglers) return {from, to};
  const OutermostHeights outermost(point, axis, all);
  float *const low_two = low + few, *const high_two = high - few;
  std::nth_element(low, low_two, high + 1);
  const double from_two = origin + *low_two;
  std::nth_element(low_two, high_two, high + 1);
  const double to_two = origin + *high_two;
  const double low_end = endFrom(from, from_two, to, surface), high_end = endFrom(to, to_two, from, surface);
  const double first = surface == Surface::tapered ? narrowEnd(low_end, outermost, from, from_two, few)
                                                   : std::max(outermost.low, low_end);
  return {first, std::min(outermost.high, high_end)};
}

/// x of the frame: from the axis towards the side that was seen.
Eigen::Matrix3d frameTowardsSeenSide(const Vec3& point, const Vec3& axis,
                                     const SomePoints<kMostExtentPoints>& inliers) {
  return frameAround(axis, inliers.mean() - point);
}

}  // namespace

Extent extentAlong(const Cylinder& cylinder, const SeenPoints& inliers, Ends ends) {
  const SomePoints<kMostExtentPoints> some(inliers);
  const AxisRange range = rangeAlong(cylinder.point, cylinder.axis, inliers, some, Surface::even, ends);
  Extent extent;
  extent.origin = cylinder.point + 0.5 * (range.low + range.high) * cylinder.axis;
  extent.rotation = frameTowardsSeenSide(cylinder.point, cylinder.axis, some);
  extent.size.z() = range.high - range.low;
  extent.radius = cylinder.radius;
  extent.unseen_ends = kEndsUnknown;
  return extent;
}

Extent extentAlong(const Cone& cone, const SeenPoints& inliers, Ends ends) {
  const SomePoints<kMostExtentPoints> some(inliers);
  AxisRange range = rangeAlong(cone.apex, cone.axis, inliers, some, Surface::tapered, ends);
  range.low = std::max(range.low, 0.0);
  range.high = std::max(range.high, range.low);
  Extent extent;
  extent.origin = cone.apex + 0.5 * (range.low + range.high) * cone.axis;
  extent.rotation = frameTowardsSeenSide(cone.apex, cone.axis, some);
  extent.size.z() = range.high - range.low;
  extent.radius = range.high * std::tan(cone.half_angle);
  extent.radius_small = range.low * std::tan(cone.half_angle);
  extent.unseen_ends = kEndsUnknown;
  return extent;
}

void moveEnds(double low, double high, const Shape& shape, Extent& extent) {
  if (const Cone* cone = std::get_if<Cone>(&shape)) {
    extent.radius += high * std::tan(cone->half_angle);
    extent.radius_small += low * std::tan(cone->half_angle);
  }
  extent.origin += 0.5 * (low + high) * extent.rotation.col(2);
  extent.size.z() += high - low;
}

void keepTo(const AxisPart& part, const Shape& shape, Extent& extent) {
  const double half = 0.5 * extent.size.z();
  moveEnds(part.low + half, part.high - half, shape, extent);
}

}  // namespace primitect
