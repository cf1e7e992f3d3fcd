// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Monotone chain and turning sides; see hull.h.
#include "core/hull.h"

#include <algorithm>
#include <limits>

#include "kernels/loops.h"

namespace primitect {
namespace {

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Points that a hull has as corners, and few others: those that do not lie within the octagon of the outermost.
List<Vec2> outermost(const List<Vec2>& points) {
  // Along x, x + y, y and y - x, and back: as the corners come around the hull, counter-clockwise.
  constexpr std::size_t kAxes = 4, kDirections = 2 * kAxes;
  double farthest[kDirections];
  Vec2 corners[kDirections];
  std::fill_n(farthest, kDirections, -std::numeric_limits<double>::infinity());
  for (const Vec2& p : points) {
    const double along[kAxes] = {p.x(), p.x() + p.y(), p.y(), p.y() - p.x()};
    for (std::size_t k = 0; k < kAxes; ++k) {
      if (along[k] > farthest[k]) farthest[k] = along[k], corners[k] = p;
      if (-along[k] > farthest[kAxes + k]) farthest[kAxes + k] = -along[k], corners[kAxes + k] = p;
    }
  }
  // From a corner, in float, which is what points are measured in: those as near to a side as it rounds stay.
  const Vec2 from = corners[0];
  kernels::FlatSide sides[kDirections];
  std::size_t count = 0;
  double longest = 0.0;
  for (std::size_t k = 0; k < kDirections; ++k) {
    const Vec2 side = corners[(k + 1) % kDirections] - corners[k];
    const double length = side.norm();
    if (!(length > 0.0)) continue;
    const Vec2 inward(-side.y() / length, side.x() / length);
    sides[count++] = {static_cast<float>(inward.x()), static_cast<float>(inward.y()), 0.0f,
                      static_cast<float>(inward.dot(corners[k] - from))};
    longest = std::max(longest, length);
  }
  if (count == 0) return {};  // all in one place
  List<float> x(points.size()), y(points.size()), z(points.size(), 0.0f), depth(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    x[k] = static_cast<float>(points[k].x() - from.x()), y[k] = static_cast<float>(points[k].y() - from.y());
  }
  kernels::loops().depths({sides, count}, x.data(), y.data(), z.data(), points.size(), depth.data());
  const auto rounding = static_cast<float>(1e-5 * longest);
  List<Vec2> outer;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!(depth[k] > rounding)) outer.push_back(points[k]);
  }
  return outer;
}

/// Appends the corners of the half from `first` to `last`, of sorted points, on whose right side none lies; without the
/// last.
template <class Point>
void addHalf(Point first, Point last, List<Vec2>& hull) {
  const std::size_t start = hull.size();
  for (Point p = first; p != last; ++p) {
    while (hull.size() >= start + 2 && !(cross(hull[hull.size() - 2], hull.back(), *p) > 0.0)) hull.pop_back();
    hull.push_back(*p);
  }
  hull.pop_back();
}

/// Appends of the corners after `begin`, before `end`, those that stand out by more than `flat` (m) from what is kept
/// (Douglas and Peucker, 1973). One by one from neighbour to neighbour a sharp corner would be lost where many are near
/// it: each stands out little over the next.
void keepOutstanding(const List<Vec2>& hull, std::size_t begin, std::size_t end, double flat, List<Vec2>& kept) {
  const Vec2 &from = hull[begin], &to = hull[end % hull.size()];
  const double length = (to - from).norm();
  std::size_t farthest = begin;
  double most = flat * length;
  for (std::size_t k = begin + 1; k < end; ++k) {
    const double area = cross(from, hull[k], to);
    if (area > most) most = area, farthest = k;
  }
  if (farthest == begin) return;
  keepOutstanding(hull, begin, farthest, flat, kept);
  kept.push_back(hull[farthest]);
  keepOutstanding(hull, farthest, end, flat, kept);
}

/// Where halves meet, the point may lie in the middle of a side.
void dropFlat(std::size_t k, double flat, List<Vec2>& corners) {
  const std::size_t count = corners.size();
  const Vec2 &before = corners[(k + count - 1) % count], &after = corners[(k + 1) % count];
  const bool stands_out = cross(before, corners[k], after) > flat * (after - before).norm();
  if (count > 3 && !stands_out) corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(k));
}

}  // namespace

List<Vec2> convexHull(const List<Vec2>& all, double flat) {
  List<Vec2> points = outermost(all);
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  List<Vec2> hull;
  addHalf(points.begin(), points.end(), hull);
  const std::size_t middle = hull.size();
  addHalf(points.rbegin(), points.rend(), hull);
  List<Vec2> kept = {hull.front()};
  keepOutstanding(hull, 0, middle, flat, kept);
  const std::size_t rightmost = kept.size();
  kept.push_back(hull[middle]);
  keepOutstanding(hull, middle, hull.size(), flat, kept);
  for (const std::size_t k : {rightmost, std::size_t{0}}) dropFlat(k, flat, kept);
  return kept;
}

Rectangle smallestRectangle(const List<Vec2>& corners) {
  Rectangle smallest = rectangleAlong(Vec2::UnitX(), corners);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 side = corners[(k + 1) % corners.size()] - corners[k];
    if (!(side.norm() > 0.0)) continue;
    const Rectangle along = rectangleAlong(side.normalized(), corners);
    if (along.size.prod() < smallest.size.prod()) smallest = along;
  }
  if (smallest.size.x() >= smallest.size.y()) return smallest;
  return {{-smallest.x.y(), smallest.x.x()}, smallest.middle, {smallest.size.y(), smallest.size.x()}};
}

}  // namespace primitect
