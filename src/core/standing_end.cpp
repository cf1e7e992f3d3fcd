// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of axes against planes; see standing_end.h.
#include "core/standing_end.h"

#include <cmath>

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
  const Kind kind = kindOf(shape);
  if (kind != Kind::cylinder && kind != Kind::cone) return;
  const Plane& face = std::get<Plane>(plane.shape);
  const Vec3 axis = extent.rotation.col(2);
  const double cosine = face.normal.dot(axis);
  if (std::abs(cosine) < kLeastCosine) return;
  // The end that is farther behind.
  const double way = cosine > 0.0 ? -0.5 : 0.5;  // of the length, from the origin
  const Vec3 end = extent.origin + way * extent.size.z() * axis;
  const double behind = -distance(face, end);
  const double too_long = behind / std::abs(cosine);
  if (!(behind > 0.0 && behind < reach && too_long < extent.size.z())) return;
  const Vec3 meets = end + (behind / cosine) * axis;
  // At the edge of a table half of the foot may be beyond it.
  if (!holds(plane, meets, extent.radius)) return;
  extent.size.z() -= too_long;
  extent.origin = meets - way * extent.size.z() * axis;
  if (const Cone* cone = std::get_if<Cone>(&shape)) {
    (way > 0.0 ? extent.radius : extent.radius_small) +=
        (way > 0.0 ? -1.0 : 1.0) * too_long * std::tan(cone->half_angle);
  }
}

}  // namespace primitect
