// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Outlines of planes and ends of axes; see extent.h.
#include "core/extent.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace primitect {
namespace {

using Vec2 = Eigen::Vector2d;

/// A right-handed frame with this z axis and x as near to `towards` as can be.
Eigen::Matrix3d frameAround(const Vec3& z, const Vec3& towards) {
  const Vec3 across = towards - towards.dot(z) * z;
  const Vec3 x = across.norm() > 1e-9 ? Vec3(across.normalized()) : z.unitOrthogonal();
  Eigen::Matrix3d frame;
  frame << x, z.cross(x), z;
  return frame;
}

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Convex hull, counter-clockwise (monotone chain, Andrew 1979).
std::vector<Vec2> convexHull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Vec2> hull;
  const auto addChain = [&hull](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), *p) <= 0.0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  if (points.size() < 3) return points;
  addChain(points.begin(), points.end());
  addChain(points.rbegin(), points.rend());
  return hull;
}

/// Direction of the largest spread of the points within the plane.
Vec3 longestDirection(const std::vector<Vec3>& points, const Vec3& mean, const Vec3& normal) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vec3& point : points) {
    const Vec3 offset = point - mean;
    const Vec3 in_plane = offset - offset.dot(normal) * normal;
    scatter.noalias() += in_plane * in_plane.transpose();
  }
  const Vec3 direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
  // Of the two signs the one towards positive x, so that the pose does not flip.
  return direction.x() < 0.0 ? Vec3(-direction) : direction;
}

/// The points of the part that holds most of them: cells of three mean spacings that touch belong together. Points of
/// other objects that happen to lie in the plane do not stretch the outline.
std::vector<Vec2> largestPart(const std::vector<Vec2>& points) {
  Vec2 low = points.front(), high = points.front();
  for (const Vec2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double count = static_cast<double>(points.size());
  // Spacing of points spread over the box, or along a strip.
  const double spacing = std::max(std::sqrt((high - low).prod() / count), (high - low).maxCoeff() / count);
  const double cell = 3.0 * spacing;
  if (!(cell > 0.0)) return points;
  const auto cellOf = [&](const Vec2& point) {
    const Vec2 place = (point - low) / cell;
    return std::make_pair(static_cast<int>(place.x()), static_cast<int>(place.y()));
  };
  std::map<std::pair<int, int>, std::vector<Vec2>> cells;
  for (const Vec2& point : points) cells[cellOf(point)].push_back(point);
  std::vector<Vec2> largest;
  while (!cells.empty()) {
    std::vector<Vec2> part;
    std::vector<std::pair<int, int>> open = {cells.begin()->first};
    while (!open.empty()) {
      const std::pair<int, int> at = open.back();
      open.pop_back();
      const auto found = cells.find(at);
      if (found == cells.end()) continue;
      part.insert(part.end(), found->second.begin(), found->second.end());
      cells.erase(found);
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) open.emplace_back(at.first + dx, at.second + dy);
      }
    }
    if (part.size() > largest.size()) largest = part;
  }
  return largest;
}

Extent extentOf(const Plane& plane, const std::vector<Vec3>& inliers) {
  Extent extent;
  Vec3 mean = Vec3::Zero();
  for (const Vec3& inlier : inliers) mean += inlier / static_cast<double>(inliers.size());
  mean -= distance(plane, mean) * plane.normal;
  extent.rotation = frameAround(plane.normal, longestDirection(inliers, mean, plane.normal));
  std::vector<Vec2> flat;
  for (const Vec3& inlier : inliers) flat.push_back((extent.rotation.transpose() * (inlier - mean)).head<2>());
  flat = largestPart(flat);
  Vec2 low = flat.front(), high = flat.front();
  for (const Vec2& point : flat) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vec2 center = 0.5 * (low + high);
  extent.origin = mean + extent.rotation.leftCols<2>() * center;
  extent.size.head<2>() = high - low;
  for (const Vec2& corner : convexHull(flat)) extent.hull.push_back(mean + extent.rotation.leftCols<2>() * corner);
  return extent;
}

Extent extentOf(const Sphere& sphere, const std::vector<Vec3>&) {
  Extent extent;
  extent.origin = sphere.center;
  extent.radius = sphere.radius;
  return extent;
}

/// Where along point + t * axis the inliers lie, without the outer 1 %.
struct AxisRange {
  double low, high;
};

AxisRange rangeAlong(const Vec3& point, const Vec3& axis, const std::vector<Vec3>& inliers) {
  constexpr double kStragglers = 0.01;
  std::vector<double> heights;
  for (const Vec3& inlier : inliers) heights.push_back((inlier - point).dot(axis));
  std::sort(heights.begin(), heights.end());
  const std::size_t skipped = static_cast<std::size_t>(kStragglers * static_cast<double>(heights.size()));
  return {heights[skipped], heights[heights.size() - 1 - skipped]};
}

/// x of the frame: from the axis towards the side that was seen.
Eigen::Matrix3d frameTowardsSeenSide(const Vec3& point, const Vec3& axis, const std::vector<Vec3>& inliers) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& inlier : inliers) sum += inlier - point;
  return frameAround(axis, sum);
}

Extent extentOf(const Cylinder& cylinder, const std::vector<Vec3>& inliers) {
  const AxisRange range = rangeAlong(cylinder.point, cylinder.axis, inliers);
  Extent extent;
  extent.origin = cylinder.point + 0.5 * (range.low + range.high) * cylinder.axis;
  extent.rotation = frameTowardsSeenSide(cylinder.point, cylinder.axis, inliers);
  extent.size.z() = range.high - range.low;
  extent.radius = cylinder.radius;
  return extent;
}

Extent extentOf(const Cone& cone, const std::vector<Vec3>& inliers) {
  AxisRange range = rangeAlong(cone.apex, cone.axis, inliers);
  range.low = std::max(range.low, 0.0);
  range.high = std::max(range.high, range.low);
  Extent extent;
  extent.origin = cone.apex + 0.5 * (range.low + range.high) * cone.axis;
  extent.rotation = frameTowardsSeenSide(cone.apex, cone.axis, inliers);
  extent.size.z() = range.high - range.low;
  extent.radius = range.high * std::tan(cone.half_angle);
  extent.radius_small = range.low * std::tan(cone.half_angle);
  return extent;
}

bool pointsUp(const Vec3& axis) {
  constexpr double kLevel = 1e-9;
  if (std::abs(axis.y()) > kLevel) return axis.y() < 0.0;
  if (std::abs(axis.x()) > kLevel) return axis.x() > 0.0;
  return axis.z() > 0.0;
}

}  // namespace

Extent measureExtent(const Shape& shape, const std::vector<Vec3>& inliers) {
  if (inliers.empty()) return {};
  return std::visit([&inliers](const auto& s) { return extentOf(s, inliers); }, shape);
}

Shape canonical(const Shape& shape) {
  const Cylinder* cylinder = std::get_if<Cylinder>(&shape);
  if (!cylinder || pointsUp(cylinder->axis)) return shape;
  return Cylinder{cylinder->point, -cylinder->axis, cylinder->radius};
}

}  // namespace primitect
