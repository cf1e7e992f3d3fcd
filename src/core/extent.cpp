// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Outlines of planes and ends of axes; see extent.h.
#include "core/extent.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/float_range.h"
#include "core/frame_memory.h"
#include "core/hull.h"

namespace primitect {
namespace {

/// A right-handed frame with this z axis and x as near to `towards` as can be.
Eigen::Matrix3d frameAround(const Vec3& z, const Vec3& towards) {
  const Vec3 across = towards - towards.dot(z) * z;
  const Vec3 x = across.norm() > 1e-9 ? Vec3(across.normalized()) : z.unitOrthogonal();
  Eigen::Matrix3d frame;
  frame << x, z.cross(x), z;
  return frame;
}

/// For what is a mean, and the ends of axes, where 1 % of the points lie beyond: 20 of these.
constexpr std::size_t kMostPoints = 2039;

/// Enough to say which way a plane is longer. Prime, as above: the step through the points is then seldom in time with
/// the rows of an image.
constexpr std::size_t kMostForDirection = 251;

/// Of the two signs of a direction this one, so that the pose does not flip.
Vec3 towardsPositiveX(const Vec3& direction) { return direction.x() < 0.0 ? Vec3(-direction) : direction; }

/// Direction of the largest spread of the points within the plane.
Vec3 longestDirection(const SomePoints<kMostForDirection>& points, const Vec3& mean, const Vec3& normal) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < points.count; ++k) {
    const Vec3 offset = points.point(k) - mean;
    scatter.noalias() += offset * offset.transpose();
  }
  const Eigen::Matrix3d within = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  scatter = (within * scatter * within).eval();
  const Vec3 direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
  return towardsPositiveX(direction);
}

template <std::size_t most>
Vec3 meanOf(const SomePoints<most>& points) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < points.count; ++k) sum += Vec3(points.x[k], points.y[k], points.z[k]);
  return points.origin + sum / static_cast<double>(points.count);
}

/// The points in the frame of a plane (m, from the origin).
struct FlatPoints {
  List<float> u, v;

  FlatPoints(const SeenPoints& points, const Eigen::Matrix3d& rotation, const Vec3& origin)
      : u(points.size()), v(points.size()) {
    const Eigen::Vector3f x = rotation.col(0).cast<float>(), y = rotation.col(1).cast<float>();
    const Eigen::Vector3f from = (rotation.transpose() * (points.origin - origin)).cast<float>();
    for (std::size_t i = 0; i < u.size(); ++i) {
      u[i] = from.x() + x.x() * points.x[i] + x.y() * points.y[i] + x.z() * points.z[i];
      v[i] = from.y() + y.x() * points.x[i] + y.y() * points.y[i] + y.z() * points.z[i];
    }
  }
  Vec2 at(std::size_t i) const { return {u[i], v[i]}; }
};

/// Square cells over a box, some of them with points.
class Cells {
 public:
  explicit Cells(const FlatPoints& points) : cell_of_(points.u.size()) {
    const FloatRange in_u(points.u.data(), points.u.size()), in_v(points.v.data(), points.v.size());
    low_u_ = in_u.low, low_v_ = in_v.low;
    const float across = in_u.high - low_u_, down = in_v.high - low_v_;
    const float count = static_cast<float>(points.u.size());
    // Spacing of points spread over the box, or along a strip.
    const float spacing = std::max(std::sqrt(across * down / count), std::max(across, down) / count);
    const float cell = 3.0f * spacing;
    per_cell_ = cell > 0.0f ? 1.0f / cell : 0.0f;
    // One empty cell around all: no neighbour is outside.
    columns_ = static_cast<int>(across * per_cell_) + 3;
    rows_ = static_cast<int>(down * per_cell_) + 3;
    counts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    for (std::size_t i = 0; i < cell_of_.size(); ++i) {
      const int column = static_cast<int>((points.u[i] - low_u_) * per_cell_) + 1;
      const int row = static_cast<int>((points.v[i] - low_v_) * per_cell_) + 1;
      cell_of_[i] = row * columns_ + column;
      ++counts_[static_cast<std::size_t>(cell_of_[i])];
    }
  }

  /// Leaves the parts, of cells that touch each other, which hold at least this share of what the largest part holds.
  void keepParts(double share) {
    List<int> part(counts_.size(), 0), open;
    List<int> held(1, 0);  // by each part, from 1 on
    for (std::size_t first = 0; first < counts_.size(); ++first) {
      if (counts_[first] == 0 || part[first] != 0) continue;
      held.push_back(fill(static_cast<int>(first), static_cast<int>(held.size()), part, open));
    }
    const double least = share * *std::max_element(held.begin(), held.end());
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      if (held[static_cast<std::size_t>(part[k])] < least) counts_[k] = 0;
    }
  }

  /// Whether what is left holds a point in the cell of that one or in one that touches it.
  bool isNear(float u, float v) const {
    if (per_cell_ == 0.0f) return false;  // points in one place: a cell has no size
    const float column = (u - low_u_) * per_cell_ + 1.0f, row = (v - low_v_) * per_cell_ + 1.0f;
    const float columns = static_cast<float>(columns_), rows = static_cast<float>(rows_);
    if (!(column >= 0.0f && column < columns && row >= 0.0f && row < rows)) return false;
    const int at_column = static_cast<int>(column), at_row = static_cast<int>(row);
    for (int r = std::max(at_row - 1, 0); r <= std::min(at_row + 1, rows_ - 1); ++r) {
      for (int c = std::max(at_column - 1, 0); c <= std::min(at_column + 1, columns_ - 1); ++c) {
        if (count(r * columns_ + c) > 0) return true;
      }
    }
    return false;
  }

  /// Points that may be corners of the hull of all that are left. None of a cell whose four diagonal neighbours hold
  /// points is one: in whatever direction, one of these lies farther out.
  List<Vec2> border(const FlatPoints& points) const {
    List<char> at_border(counts_.size(), 0);
    for (int k = columns_ + 1; k + columns_ + 1 < static_cast<int>(counts_.size()); ++k) {
      const bool amid =
          count(k - columns_ - 1) && count(k - columns_ + 1) && count(k + columns_ - 1) && count(k + columns_ + 1);
      at_border[static_cast<std::size_t>(k)] = count(k) > 0 && !amid;
    }
    List<Vec2> result;
    for (std::size_t i = 0; i < cell_of_.size(); ++i) {
      if (at_border[static_cast<std::size_t>(cell_of_[i])]) result.push_back(points.at(i));
    }
    return result;
  }

 private:
  int count(int cell) const { return counts_[static_cast<std::size_t>(cell)]; }

  int fill(int first, int number, List<int>& part, List<int>& open) const {
    int held = 0;
    open.assign(1, first);
    part[static_cast<std::size_t>(first)] = number;
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      held += count(at);
      for (const int next : {at - columns_ - 1, at - columns_, at - columns_ + 1, at - 1, at + 1, at + columns_ - 1,
                             at + columns_, at + columns_ + 1}) {
        if (count(next) == 0 || part[static_cast<std::size_t>(next)] != 0) continue;
        part[static_cast<std::size_t>(next)] = number;
        open.push_back(next);
      }
    }
    return held;
  }

  float low_u_, low_v_, per_cell_;
  int columns_ = 0, rows_ = 0;
  List<int> counts_;
  List<int> cell_of_;  ///< of each point
};

/// The outline is around all large parts: something in front may hide what lies between them. A few points of other
/// objects that happen to lie in the plane do not stretch it. Parts are cells of three mean spacings that touch.
Extent extentOf(const Plane& plane, const SeenPoints& inliers, const SeenPoints& outermost,
                std::vector<Vec3>& outline) {
  const SomePoints<kMostForDirection> some(inliers);
  const Vec3 mean = meanOf(some);
  Extent extent;
  extent.rotation = frameAround(plane.normal, longestDirection(some, mean, plane.normal));
  const FlatPoints flat(inliers, extent.rotation, inliers.origin);
  Cells cells(flat);
  constexpr double kLeastPart = 0.2;
  cells.keepParts(kLeastPart);
  List<Vec2> border = cells.border(flat);
  const FlatPoints flat_outermost(outermost, extent.rotation, inliers.origin);
  for (std::size_t i = 0; i < outermost.size(); ++i) {
    if (cells.isNear(flat_outermost.u[i], flat_outermost.v[i])) border.push_back(flat_outermost.at(i));
  }
  // A millimetre of a metre: less than the noise at a border, and half the corners.
  constexpr double kFlat = 1e-3;
  const Vec3 foot = inliers.origin - distance(plane, inliers.origin) * plane.normal;
  const Eigen::Matrix<double, 3, 2> axes = extent.rotation.leftCols<2>();
  const Rectangle along = rectangleAlong(Vec2::UnitX(), border);
  const List<Vec2> corners = convexHull(border, kFlat * along.size.norm());
  extent.hull = std::move(outline);
  extent.hull.clear();
  for (const Vec2& corner : corners) extent.hull.push_back(foot + axes * corner);
  // Points in one place have no hull.
  const Rectangle around = corners.empty() ? along : smallestRectangle(corners);
  extent.origin = foot + axes * around.middle;
  extent.size.head<2>() = around.size;
  extent.rotation = frameAround(plane.normal, towardsPositiveX(axes * around.x));
  return extent;
}

Extent extentOf(const Sphere& sphere, const SeenPoints&, const SeenPoints&, std::vector<Vec3>&) {
  Extent extent;
  extent.origin = sphere.center;
  extent.radius = sphere.radius;
  return extent;
}

/// How far the ends of an axis go.
enum class Ends { without_stragglers, to_the_end };

/// Where along point + t * axis the inliers lie.
struct AxisRange {
  double low, high;
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
double narrowEnd(double end, double outermost, double next, double one, double two, std::size_t few) {
  constexpr double kDeviations = 2.0, kStraggler = 4.0;  // times the surface that there is for each point
  if (few == 0) return std::max(outermost, end);
  const auto areaOf = [](double height) { return areaUpTo(height, Surface::tapered); };
  const double hundredth = areaOf(two) - areaOf(one), count = static_cast<double>(few);
  if (areaOf(end) >= kDeviations * std::sqrt(2.0 / count) * hundredth) return std::max(outermost, end);
  return areaOf(next) - areaOf(outermost) > kStraggler * hundredth / count ? next : outermost;
}

AxisRange rangeAlong(const Vec3& point, const Vec3& axis, const SomePoints<kMostPoints>& inliers, Surface surface,
                     Ends ends) {
  constexpr double kStragglers = 0.01;
  float heights[SomePoints<kMostPoints>::kRoom];
  heightsAlong(axis, inliers.x, inliers.y, inliers.z, inliers.count, heights);
  const auto few = static_cast<std::size_t>(kStragglers * static_cast<double>(inliers.count));
  float *const end = heights + inliers.count, *const low = heights + few, *const high = end - 1 - few;
  const double origin = (inliers.origin - point).dot(axis);
  std::nth_element(heights, low, end);
  const double from = origin + *low;
  std::nth_element(low, high, end);
  const double to = origin + *high;
  if (ends == Ends::without_stragglers) return {from, to};
  // Those before `low` and after `high` lie beyond them still. Of less than a hundred points there are none, and `low`
  // is not where it was.
  const double highest = origin + *std::max_element(high, end);
  std::partial_sort(heights, heights + std::min<std::size_t>(few, 2), low);
  const double lowest = few > 0 ? origin + heights[0] : from, next = few > 1 ? origin + heights[1] : from;
  float *const low_two = low + few, *const high_two = high - few;
  std::nth_element(low, low_two, high + 1);
  const double from_two = origin + *low_two;
  std::nth_element(low_two, high_two, high + 1);
  const double to_two = origin + *high_two;
  const double low_end = endFrom(from, from_two, to, surface), high_end = endFrom(to, to_two, from, surface);
  const double first =
      surface == Surface::tapered ? narrowEnd(low_end, lowest, next, from, from_two, few) : std::max(lowest, low_end);
  return {first, std::min(highest, high_end)};
}

/// x of the frame: from the axis towards the side that was seen.
Eigen::Matrix3d frameTowardsSeenSide(const Vec3& point, const Vec3& axis, const SomePoints<kMostPoints>& inliers) {
  return frameAround(axis, meanOf(inliers) - point);
}

Extent extentOf(const Cylinder& cylinder, const SeenPoints& inliers, Ends ends) {
  const SomePoints<kMostPoints> some(inliers);
  const AxisRange range = rangeAlong(cylinder.point, cylinder.axis, some, Surface::even, ends);
  Extent extent;
  extent.origin = cylinder.point + 0.5 * (range.low + range.high) * cylinder.axis;
  extent.rotation = frameTowardsSeenSide(cylinder.point, cylinder.axis, some);
  extent.size.z() = range.high - range.low;
  extent.radius = cylinder.radius;
  return extent;
}

Extent extentOf(const Cone& cone, const SeenPoints& inliers, Ends ends) {
  const SomePoints<kMostPoints> some(inliers);
  AxisRange range = rangeAlong(cone.apex, cone.axis, some, Surface::tapered, ends);
  range.low = std::max(range.low, 0.0);
  range.high = std::max(range.high, range.low);
  Extent extent;
  extent.origin = cone.apex + 0.5 * (range.low + range.high) * cone.axis;
  extent.rotation = frameTowardsSeenSide(cone.apex, cone.axis, some);
  extent.size.z() = range.high - range.low;
  extent.radius = range.high * std::tan(cone.half_angle);
  extent.radius_small = range.low * std::tan(cone.half_angle);
  return extent;
}

template <class T>
Extent extentOf(const T& along_axis, const SeenPoints& inliers, const SeenPoints&, std::vector<Vec3>&) {
  return extentOf(along_axis, inliers, Ends::without_stragglers);
}

bool pointsUp(const Vec3& axis) {
  constexpr double kLevel = 1e-9;
  if (std::abs(axis.y()) > kLevel) return axis.y() < 0.0;
  if (std::abs(axis.x()) > kLevel) return axis.x() > 0.0;
  return axis.z() > 0.0;
}

}  // namespace

Extent measureExtent(const Shape& shape, const SeenPoints& inliers, const SeenPoints& outermost,
                     std::vector<Vec3> outline) {
  if (inliers.empty()) return {};
  return std::visit([&](const auto& s) { return extentOf(s, inliers, outermost, outline); }, shape);
}

Extent measureExtent(const Shape& shape, const SeenPoints& inliers, std::vector<Vec3> outline) {
  return measureExtent(shape, inliers, {}, std::move(outline));
}

void measureToTheEnds(const Shape& shape, const SeenPoints& inliers, Extent& extent) {
  if (inliers.empty()) return;
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    extent = extentOf(*cylinder, inliers, Ends::to_the_end);
  } else if (const Cone* cone = std::get_if<Cone>(&shape)) {
    extent = extentOf(*cone, inliers, Ends::to_the_end);
  }
}

Shape canonical(const Shape& shape) {
  const Cylinder* cylinder = std::get_if<Cylinder>(&shape);
  if (!cylinder || pointsUp(cylinder->axis)) return shape;
  return Cylinder{cylinder->point, -cylinder->axis, cylinder->radius};
}

}  // namespace primitect
