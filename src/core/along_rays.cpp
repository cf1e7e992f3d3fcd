// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points that their rays move; see along_rays.h.
#include "core/along_rays.h"

#include "core/flat.h"

namespace primitect {

kernels::FitPoints AlongRays::pointsFor(const Shape& shape) {
  const kernels::FitPoints all = points_.view();
  const Eigen::Vector3f origin = points_.origin().cast<float>();
  kernels::loops().alongRays(flattened(shape, points_.origin()), {origin.x(), origin.y(), origin.z()}, all, x_.data(),
                             y_.data(), z_.data());
  return {x_.data(), y_.data(), z_.data(), all.inverse_tolerance, all.count};
}

SeenPoints AlongRays::seenFor(const Shape& shape) {
  const kernels::FitPoints moved = pointsFor(shape);
  SeenPoints seen;
  seen.origin = points_.origin();
  seen.x.assign(moved.x, moved.x + points_.size());
  seen.y.assign(moved.y, moved.y + points_.size());
  seen.z.assign(moved.z, moved.z + points_.size());
  return seen;
}

}  // namespace primitect
