// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The sides of a part, from its extent; see observed_part.h.
#include "core/observed_part.h"

#include <Eigen/Geometry>

namespace primitect {

void ObservedPart::addSide(const Vec3& inward, const Vec3& point) {
  const Eigen::Vector3f direction = inward.cast<float>();
  sides_.push_back({direction.x(), direction.y(), direction.z(), static_cast<float>(inward.dot(point))});
}

ObservedPart::ObservedPart(const Shape& shape, const Extent& extent) {
  const Vec3 z = extent.rotation.col(2);
  switch (kindOf(shape)) {
    case Kind::plane:
      for (std::size_t k = 0; k < extent.hull.size(); ++k) {
        // Counter-clockwise: what is to the left of every edge is inside.
        const Vec3& corner = extent.hull[k];
        const Vec3 inward = z.cross(extent.hull[(k + 1) % extent.hull.size()] - corner);
        if (inward.norm() > 0.0) addSide(inward.normalized(), corner);
      }
      break;
    case Kind::sphere:
      break;
    case Kind::cylinder:
    case Kind::cone:
      addSide(z, extent.origin - 0.5 * extent.size.z() * z);
      addSide(-z, extent.origin + 0.5 * extent.size.z() * z);
  }
  for (int k = 0; k < 3; ++k) center_[k] = static_cast<float>(extent.origin[k]);
  const float ball = depth(center_[0], center_[1], center_[2]);
  ball_sq_ = ball > 0.0f ? ball * ball : -1.0f;
}

void ObservedPart::addSidesNear(float x, float y, float z, float radius, List<kernels::FlatSide>& sides) const {
  for (const kernels::FlatSide& side : sides_) {
    if (side.x * x + side.y * y + side.z * z - side.offset <= radius) sides.push_back(side);
  }
}

}  // namespace primitect
