// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which part is measured how; see extent.h.
#include "core/extent.h"

#include <cmath>
#include <utility>

#include "core/plane_outline.h"

namespace primitect {
namespace {

/// Of what lies, noise alone would say which end is higher.
bool pointsUp(const Vec3& axis) {
  constexpr double kLying = 0.087;  // 5 deg
  if (std::abs(axis.y()) > kLying) return axis.y() < 0.0;
  if (std::abs(axis.x()) > kLying) return axis.x() > 0.0;
  return axis.z() > 0.0;
}

}  // namespace

Extent measureExtent(const Shape& shape, const SeenPoints& inliers, const SeenPoints& outermost,
                     std::vector<Vec3> outline) {
  if (inliers.empty()) return {};
  if (const Plane* plane = std::get_if<Plane>(&shape)) return outlineOf(*plane, inliers, outermost, std::move(outline));
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    return extentAlong(*cylinder, inliers, Ends::without_stragglers);
  }
  if (const Cone* cone = std::get_if<Cone>(&shape)) return extentAlong(*cone, inliers, Ends::without_stragglers);
  const Sphere& sphere = std::get<Sphere>(shape);
  Extent extent;
  extent.origin = sphere.center;
  extent.radius = sphere.radius;
  return extent;
}

Extent measureExtent(const Shape& shape, const SeenPoints& inliers, std::vector<Vec3> outline) {
  return measureExtent(shape, inliers, {}, std::move(outline));
}

void measureToTheEnds(const Shape& shape, const SeenPoints& inliers, Extent& extent) {
  if (inliers.empty()) return;
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    extent = extentAlong(*cylinder, inliers, Ends::to_the_end);
  } else if (const Cone* cone = std::get_if<Cone>(&shape)) {
    extent = extentAlong(*cone, inliers, Ends::to_the_end);
  }
}

Shape canonical(const Shape& shape) {
  const Cylinder* cylinder = std::get_if<Cylinder>(&shape);
  if (!cylinder || pointsUp(cylinder->axis)) return shape;
  return Cylinder{cylinder->point, -cylinder->axis, cylinder->radius};
}

}  // namespace primitect
