// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Trying tapers one by one; see tapered.h.
#include "core/tapered.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/flat.h"

namespace primitect {
namespace {

/// Half angles (rad) near enough to each other that Gauss-Newton gets from one to the next.
constexpr double kTapers[] = {0.1, 0.25, 0.45};

}  // namespace

double agreement(const Shape& shape, const FitPoints& points) {
  constexpr std::size_t kAtOnce = 256;
  std::array<float, kAtOnce> distance;
  const kernels::FlatShape flat = flattened(shape, points.origin());
  const kernels::FitPoints p = points.view();
  double sum = 0.0;
  for (std::size_t begin = 0; begin < p.count; begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, p.count - begin);
    kernels::loops().distances(flat, p.x + begin, p.y + begin, p.z + begin, count, distance.data());
    std::array<float, kernels::kLanes> some = {};
    for (std::size_t k = 0; k < count; ++k) {
      const float share = distance[k] * p.inverse_tolerance[begin + k];
      some[k % kernels::kLanes] += share * share < 1.0f ? 1.0f - share * share : 0.0f;
    }
    for (const float of_lane : some) sum += of_lane;
  }
  return sum;
}

Cone tapered(const Cylinder& cylinder, const FitPoints& points) {
  const Vec3& middle = points.middle();
  const Vec3 foot = cylinder.point + (middle - cylinder.point).dot(cylinder.axis) * cylinder.axis;
  const Vec3 outward = normalAt(cylinder, middle), seen = foot + cylinder.radius * outward;
  Cone best;
  double most = -1.0;
  for (const double taper : kTapers) {
    for (const double way : {-1.0, 1.0}) {
      const Vec3 opening = way * cylinder.axis, apex = seen - cylinder.radius / std::tan(taper) * opening;
      const Cone cone = {apex, std::cos(taper) * opening - std::sin(taper) * outward, taper};
      const double agreed = agreement(cone, points);
      if (!(agreed > most)) continue;
      most = agreed;
      best = cone;
    }
  }
  return best;
}

}  // namespace primitect
