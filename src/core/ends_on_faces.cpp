// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of axes against planes; see ends_on_faces.h.
#include "core/ends_on_faces.h"

#include <cmath>

#include "core/axis_extent.h"
#include "core/observed_part.h"

namespace primitect {
namespace {

bool holds(const Detection& plane, const Vec3& place, double margin) {
  const Eigen::Vector3f p = place.cast<float>();
  return ObservedPart(plane.shape, plane.extent).holds(p.x(), p.y(), p.z(), static_cast<float>(margin));
}

}  // namespace

void endOn(const Detection& plane, double reach, const Shape& shape, Extent& extent) {
  constexpr double kLeastCosine = 0.966;  // 15 deg
  constexpr double kReachBefore = 0.6;    // with more, hidden ends come to faces that they are not on
  constexpr double kMostOfLength = 0.5;
  if (!hasAxis(kindOf(shape))) return;
  const Plane& face = std::get<Plane>(plane.shape);
  const Vec3 axis = extent.rotation.col(2);
  const double cosine = face.normal.dot(axis);
  if (std::abs(cosine) < kLeastCosine) return;
  for (const double side : {-1.0, 1.0}) {
    const double half = 0.5 * extent.size.z();
    const double along = (face.point - extent.origin).dot(face.normal) / cosine;  // from the origin to the face
    const double longer = side * along - half;
    const bool near = longer > -reach && longer < kReachBefore * reach;
    if (!near || std::abs(longer) > kMostOfLength * half) continue;
    // What stands on a face, or ends with it, has its axis on it, as well as its outline is known.
    if (!holds(plane, extent.origin + along * axis, reach)) continue;
    moveEnds(side < 0.0 ? -longer : 0.0, side > 0.0 ? longer : 0.0, shape, extent);
  }
}

}  // namespace primitect
