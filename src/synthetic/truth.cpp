// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One pass over the image collects what was seen of each surface; then each becomes a detection.
#include "synthetic/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "primitect/transforms.h"
#include "synthetic/outline.h"

namespace primitect::synthetic {
namespace {

/// What the image shows of one surface.
struct Seen {
  std::uint32_t pixels = 0;
  bool has_axis = false;
  Vec3 axis = Vec3::Zero();
  double axis_offset = 0.0;  ///< place along the axis: axis.dot(p) - axis_offset, m
  double axis_begin = std::numeric_limits<double>::max();
  double axis_end = std::numeric_limits<double>::lowest();
  int row_first = -1;  ///< columns seen in the current row
  int row_last = -1;
  std::vector<Pixel> row_ends;  ///< all corners of the convex hull are among these
};

struct AxisOf {
  Seen operator()(const Plane&) const { return {}; }
  Seen operator()(const Sphere&) const { return {}; }
  Seen operator()(const Cylinder& c) const { return along(c.axis, c.point); }
  Seen operator()(const Cone& c) const { return along(c.axis, c.apex); }

  static Seen along(const Vec3& axis, const Vec3& start) {
    Seen seen;
    seen.has_axis = true;
    seen.axis = axis;
    seen.axis_offset = axis.dot(start);
    return seen;
  }
};

void addPixel(int u, double depth, const Vec3& ray, Seen& seen) {
  ++seen.pixels;
  if (seen.row_first < 0) seen.row_first = u;
  seen.row_last = u;
  if (!seen.has_axis) return;
  const double along = depth * seen.axis.dot(ray) - seen.axis_offset;
  seen.axis_begin = std::min(seen.axis_begin, along);
  seen.axis_end = std::max(seen.axis_end, along);
}

void endRow(int v, std::vector<Seen>& all_seen) {
  for (Seen& seen : all_seen) {
    if (seen.row_first < 0) continue;
    seen.row_ends.push_back({seen.row_first, v});
    seen.row_ends.push_back({seen.row_last, v});
    seen.row_first = seen.row_last = -1;
  }
}

/// Returns the number of pixels within the range, those of no surface not counted.
std::uint32_t collect(const PinholeCamera& camera, const Rendering& rendering, const DepthRange& range,
                      std::vector<Seen>& all_seen) {
  std::uint32_t used = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * camera.width + u;
      const float depth = rendering.depth[i];
      if (rendering.surface[i] == kNoSurface || !(depth > 0.0f) || !range.contains(depth)) continue;
      addPixel(u, depth, camera.ray(u, v), all_seen[rendering.surface[i]]);
      ++used;
    }
    endRow(v, all_seen);
  }
  return used;
}

/// Any right-handed frame with this z.
Eigen::Matrix3d frameAlong(const Vec3& z_axis) {
  Eigen::Matrix3d rotation;
  rotation.col(2) = z_axis;
  rotation.col(0) = z_axis.unitOrthogonal();
  rotation.col(1) = z_axis.cross(rotation.col(0));
  return rotation;
}

/// Fills shape and extent from what was seen.
struct Describe {
  const PinholeCamera& camera;
  const Seen& seen;
  Detection& detection;

  void operator()(const Plane& plane) const {
    Extent& extent = detection.extent;
    // The sensor is the origin: the normal that points to it has a negative dot product with any point of the plane.
    const Vec3 normal = plane.normal.dot(plane.point) <= 0.0 ? plane.normal : Vec3(-plane.normal);
    const double offset = normal.dot(plane.point);
    // A pinhole image of a plane keeps convexity, so the hull may be taken, exactly, in pixels.
    for (const Pixel& corner : convexHull(seen.row_ends)) {
      const Vec3 ray = camera.ray(corner.u, corner.v);
      extent.hull.push_back(ray * (offset / normal.dot(ray)));
    }
    const Eigen::Matrix3d in_plane = frameAlong(normal);
    std::vector<Eigen::Vector2d> outline;
    for (const Vec3& corner : extent.hull) outline.push_back(in_plane.leftCols<2>().transpose() * corner);
    const Rectangle rectangle = smallestRectangle(outline);
    extent.origin = in_plane.leftCols<2>() * rectangle.center + offset * normal;
    extent.rotation.col(2) = normal;
    extent.rotation.col(0) = in_plane.leftCols<2>() * rectangle.x_axis;
    extent.rotation.col(1) = normal.cross(extent.rotation.col(0));
    extent.size = {rectangle.size_x, rectangle.size_y, 0.0};
    detection.shape = Plane{extent.origin, normal};
  }

  void operator()(const Sphere& sphere) const {
    detection.extent.origin = sphere.center;
    detection.extent.radius = sphere.radius;
  }

  void operator()(const Cylinder& cylinder) const {
    describeAxis(cylinder.point);
    detection.extent.radius = cylinder.radius;
  }

  void operator()(const Cone& cone) const {
    describeAxis(cone.apex);
    const double slope = std::tan(cone.half_angle);
    detection.extent.radius = slope * seen.axis_end;
    detection.extent.radius_small = slope * seen.axis_begin;
  }

  void describeAxis(const Vec3& start) const {
    Extent& extent = detection.extent;
    extent.origin = start + seen.axis * (0.5 * (seen.axis_begin + seen.axis_end));
    extent.rotation = frameAlong(seen.axis);
    extent.size = {0.0, 0.0, seen.axis_end - seen.axis_begin};
    extent.unseen_ends = kEndsUnknown;
  }
};

Detection describe(const Shape& shape, const PinholeCamera& camera, const Seen& seen) {
  Detection detection;
  detection.shape = shape;
  detection.inlier_count = seen.pixels;
  detection.rms_error = 0.0f;
  detection.confidence = 1.0f;
  std::visit(Describe{camera, seen, detection}, shape);
  return detection;
}

}  // namespace

Detections truthOf(const World& world, const PinholeCamera& camera, const Eigen::Isometry3d& world_from_camera,
                   const Rendering& rendering, const TruthParams& params, std::vector<int>* surface_of_item) {
  std::vector<Shape> shapes;
  std::vector<Seen> all_seen;
  for (const Surface& surface : world.surfaces()) {
    shapes.push_back(transformed(world_from_camera.inverse(), surface.shape));
    all_seen.push_back(std::visit(AxisOf{}, shapes.back()));
  }
  Detections truth;
  truth.points_in = static_cast<std::uint32_t>(camera.pixelCount());
  truth.points_used = collect(camera, rendering, params.range, all_seen);
  if (surface_of_item) surface_of_item->clear();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (all_seen[i].pixels == 0 || all_seen[i].pixels < params.min_pixels) continue;
    if (!world.surfaces()[i].primitive) continue;
    truth.items.push_back(describe(shapes[i], camera, all_seen[i]));
    truth.items.back().concave = world.surfaces()[i].concave;
    if (surface_of_item) surface_of_item->push_back(static_cast<int>(i));
  }
  return truth;
}

}  // namespace primitect::synthetic
