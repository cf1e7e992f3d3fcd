// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Frames of extents.
#pragma once

#include <Eigen/Geometry>

#include "primitect/primitives.h"

namespace primitect {

/// A right-handed frame with this z axis and x as near to `towards` as can be.
inline Eigen::Matrix3d frameAround(const Vec3& z, const Vec3& towards) {
  const Vec3 across = towards - towards.dot(z) * z;
  const Vec3 x = across.norm() > 1e-9 ? Vec3(across.normalized()) : z.unitOrthogonal();
  Eigen::Matrix3d frame;
  frame << x, z.cross(x), z;
  return frame;
}

}  // namespace primitect
