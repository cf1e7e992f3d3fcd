// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The narrow end of a cone; see cone_tip.h.
#include "core/cone_tip.h"

#include <cmath>

namespace primitect {

void endAtTip(double unresolved, const Shape& shape, Extent& extent) {
  const Cone* cone = std::get_if<Cone>(&shape);
  if (!cone || !(extent.radius_small < unresolved)) return;
  const double length = extent.radius / std::tan(cone->half_angle);
  extent.origin = cone->apex + 0.5 * length * cone->axis;
  extent.size.z() = length;
  extent.radius_small = 0.0;
}

}  // namespace primitect
