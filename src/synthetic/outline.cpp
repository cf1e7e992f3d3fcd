// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Convex hull by Andrew's monotone chain, and the rectangle by trying every edge.
#include "synthetic/outline.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace primitect::synthetic {
namespace {

/// Above 0: a, b, c turn counter-clockwise as one sees the image.
std::int64_t turn(const Pixel& a, const Pixel& b, const Pixel& c) {
  return -(static_cast<std::int64_t>(b.u - a.u) * (c.v - a.v) - static_cast<std::int64_t>(b.v - a.v) * (c.u - a.u));
}

/// Appends the hull of one side; the last corner is left to the other side, which starts there.
template <class Iterator>
void appendChain(Iterator begin, Iterator end, std::vector<Pixel>& hull) {
  const std::size_t first = hull.size();
  for (Iterator it = begin; it != end; ++it) {
    while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), *it) <= 0) hull.pop_back();
    hull.push_back(*it);
  }
  hull.pop_back();
}

Rectangle rectangleAlong(const Eigen::Vector2d& direction, const std::vector<Eigen::Vector2d>& outline) {
  const Eigen::Vector2d across(-direction.y(), direction.x());
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : outline) box.extend(Eigen::Vector2d(direction.dot(corner), across.dot(corner)));
  const Eigen::Vector2d center = box.center().x() * direction + box.center().y() * across;
  if (box.sizes().x() >= box.sizes().y()) return {center, direction, box.sizes().x(), box.sizes().y()};
  return {center, across, box.sizes().y(), box.sizes().x()};
}

}  // namespace

std::vector<Pixel> convexHull(std::vector<Pixel> pixels) {
  const auto before = [](const Pixel& a, const Pixel& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; };
  const auto same = [](const Pixel& a, const Pixel& b) { return a.u == b.u && a.v == b.v; };
  std::sort(pixels.begin(), pixels.end(), before);
  pixels.erase(std::unique(pixels.begin(), pixels.end(), same), pixels.end());
  if (pixels.size() < 3) return pixels;
  std::vector<Pixel> hull;
  appendChain(pixels.begin(), pixels.end(), hull);
  appendChain(pixels.rbegin(), pixels.rend(), hull);
  return hull;
}

Rectangle smallestRectangle(const std::vector<Eigen::Vector2d>& outline) {
  Rectangle smallest;
  double smallest_area = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d edge = outline[(i + 1) % outline.size()] - outline[i];
    if (edge.squaredNorm() == 0.0) continue;
    const Rectangle rectangle = rectangleAlong(edge.normalized(), outline);
    const double area = rectangle.size_x * rectangle.size_y;
    if (area >= smallest_area) continue;
    smallest_area = area;
    smallest = rectangle;
  }
  return smallest;
}

}  // namespace primitect::synthetic
