// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes of the four kinds.
#include "io/outlines.h"

#include <Eigen/Geometry>
#include <cmath>

namespace primitect::io {
namespace {

constexpr int kCircleCorners = 72;

/// Two unit vectors that span the plane across `axis`.
struct Across {
  Vec3 u, v;
  explicit Across(const Vec3& axis) : u(axis.unitOrthogonal()), v(axis.cross(u)) {}
  Vec3 at(double angle) const { return std::cos(angle) * u + std::sin(angle) * v; }
};

Line3 circle(const Vec3& center, const Vec3& axis, double radius) {
  const Across across(axis);
  Line3 line;
  for (int i = 0; i <= kCircleCorners; ++i)
    line.push_back(center + radius * across.at(2.0 * M_PI * i / kCircleCorners));
  return line;
}

std::vector<Line3> outline(const Plane&, const Extent& extent, const View&) {
  if (extent.hull.size() < 3) return {};
  Line3 line = extent.hull;
  line.push_back(line.front());
  return {line};
}

std::vector<Line3> outline(const Sphere& sphere, const Extent&, const View& view) {
  const Vec3 sight = view.lineOfSight(sphere.center);
  if (!view.perspective) return {circle(sphere.center, sight, sphere.radius)};
  const double distance = sight.norm();
  if (distance <= sphere.radius) return {};
  // Lines of sight touch the sphere on a circle in front of its centre (right triangle eye, touching point, centre).
  const double ratio = sphere.radius / distance;
  return {
      circle(sphere.center - ratio * ratio * sight, sight / distance, sphere.radius * std::sqrt(1.0 - ratio * ratio))};
}

/// The observed part of a cylinder or cone.
struct Frustum {
  Vec3 base, axis;
  double length = 0.0, base_radius = 0.0, top_radius = 0.0;
};

/// The two straight sides where the surface turns away from the viewer: normal * line of sight = 0.
void addSides(const Frustum& frustum, const View& view, std::vector<Line3>& lines) {
  const Across across(frustum.axis);
  const double slope = (frustum.top_radius - frustum.base_radius) / frustum.length;
  const Vec3 sight = view.lineOfSight(frustum.base);
  // With normal ~ at(angle) - slope * axis and, in perspective, the point base + base_radius * at(angle):
  const double a = across.u.dot(sight), b = across.v.dot(sight);
  const double c = slope * frustum.axis.dot(sight) - (view.perspective ? frustum.base_radius : 0.0);
  const double reach = std::hypot(a, b);
  if (std::abs(c) >= reach) return;
  for (const double sign : {-1.0, 1.0}) {
    const Vec3 out = across.at(std::atan2(b, a) + sign * std::acos(c / reach));
    lines.push_back({frustum.base + frustum.base_radius * out,
                     frustum.base + frustum.length * frustum.axis + frustum.top_radius * out});
  }
}

std::vector<Line3> outline(const Frustum& frustum, const View& view) {
  if (!(frustum.length > 0.0)) return {};
  std::vector<Line3> lines = {circle(frustum.base, frustum.axis, frustum.base_radius),
                              circle(frustum.base + frustum.length * frustum.axis, frustum.axis, frustum.top_radius)};
  addSides(frustum, view, lines);
  return lines;
}

std::vector<Line3> outline(const Cylinder& cylinder, const Extent& extent, const View& view) {
  const Vec3 axis = cylinder.axis.normalized();
  const double length = extent.size.z();
  return outline(Frustum{extent.origin - 0.5 * length * axis, axis, length, cylinder.radius, cylinder.radius}, view);
}

std::vector<Line3> outline(const Cone& cone, const Extent& extent, const View& view) {
  const Vec3 axis = cone.axis.normalized();
  const double length = extent.size.z();
  return outline(Frustum{extent.origin - 0.5 * length * axis, axis, length, extent.radius_small, extent.radius}, view);
}

/// The place between two points where the perspective begins.
Vec3 cutAtNear(const Vec3& seen, const Vec3& hidden, const View& view) {
  Vec3 inside = seen, outside = hidden;
  for (int i = 0; i < 30; ++i) {
    const Vec3 middle = 0.5 * (inside + outside);
    (view.project(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

std::vector<Line3> outlineOf(const Detection& detection, const View& view) {
  return std::visit([&](const auto& shape) { return outline(shape, detection.extent, view); }, detection.shape);
}

std::vector<Line2> projectLines(const std::vector<Line3>& lines, const View& view) {
  std::vector<Line2> projected;
  for (const Line3& line : lines) {
    Line2 current;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto pixel = view.project(line[i]);
      if (pixel && current.empty() && i > 0) current.push_back(*view.project(cutAtNear(line[i], line[i - 1], view)));
      if (!pixel && !current.empty()) current.push_back(*view.project(cutAtNear(line[i - 1], line[i], view)));
      if (pixel) current.push_back(*pixel);
      if (pixel && i + 1 < line.size()) continue;
      if (current.size() > 1) projected.push_back(current);
      current.clear();
    }
  }
  return projected;
}

}  // namespace primitect::io
