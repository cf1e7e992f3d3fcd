// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a can is among what was found.
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "primitect/detector.h"

namespace primitect::test {

/// A cylinder whose axis passes within 5 mm of this place (m), with this radius to 3 mm.
inline bool isCanFound(const Vec3& middle, double radius, const Detections& found) {
  return std::any_of(found.items.begin(), found.items.end(), [&](const Detection& item) {
    const Cylinder* can = std::get_if<Cylinder>(&item.shape);
    return can && can->axis.cross(middle - can->point).norm() < 0.005 && std::abs(can->radius - radius) < 0.003;
  });
}

}  // namespace primitect::test
