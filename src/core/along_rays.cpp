// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where rays meet a surface, by Newton's steps along them; see along_rays.h.
#include "core/along_rays.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

constexpr std::size_t kAtOnce = 256;

/// Places on rays, and how far these are from the points (units of the ray).
struct Places {
  float x[kAtOnce], y[kAtOnce], z[kAtOnce], way[kAtOnce];
};

}  // namespace

void AlongRays::moveSome(const Shape& shape, std::size_t begin, std::size_t count) {
  constexpr int kSteps = 3;
  constexpr float kLeastCosine = 0.15f;  // of ray and normal: 80 deg
  constexpr float kThere = 0.02f;        // of the tolerance
  const kernels::FitPoints all = points_.view();
  const float *const px = all.x + begin, *const py = all.y + begin, *const pz = all.z + begin;
  const Eigen::Vector3f origin = points_.origin().cast<float>();
  Places at;
  std::copy_n(px, count, at.x), std::copy_n(py, count, at.y), std::copy_n(pz, count, at.z);
  std::fill_n(at.way, count, 0.0f);
  float u[kAtOnce], v[kAtOnce], cosine[kAtOnce];
  for (std::size_t k = 0; k < count; ++k) {
    const float depth = origin.z() + pz[k];
    u[k] = (origin.x() + px[k]) / depth, v[k] = (origin.y() + py[k]) / depth;
  }
  for (int step = 0; step < kSteps; ++step) {
    const Feet<kAtOnce> feet(shape, points_.origin(), at.x, at.y, at.z, count);
    for (std::size_t k = 0; k < count; ++k) {
      cosine[k] = feet.nx[k] * u[k] + feet.ny[k] * v[k] + feet.nz[k];
      at.way[k] -= feet.distance[k] / cosine[k];
      at.x[k] = px[k] + at.way[k] * u[k], at.y[k] = py[k] + at.way[k] * v[k], at.z[k] = pz[k] + at.way[k];
    }
  }
  const Feet<kAtOnce> feet(shape, points_.origin(), at.x, at.y, at.z, count);
  for (std::size_t k = 0; k < count; ++k) {
    const float ray_sq = u[k] * u[k] + v[k] * v[k] + 1.0f;
    const bool meets = std::fabs(feet.distance[k]) * all.inverse_tolerance[begin + k] < kThere;
    const bool steep = cosine[k] * cosine[k] > kLeastCosine * kLeastCosine * ray_sq;
    const float across = -at.way[k] * (feet.nx[k] * u[k] + feet.ny[k] * v[k] + feet.nz[k]);
    const bool moves = meets & steep;
    x_[begin + k] = moves ? at.x[k] + across * feet.nx[k] : px[k];
    y_[begin + k] = moves ? at.y[k] + across * feet.ny[k] : py[k];
    z_[begin + k] = moves ? at.z[k] + across * feet.nz[k] : pz[k];
  }
}

kernels::FitPoints AlongRays::pointsFor(const Shape& shape) {
  const kernels::FitPoints all = points_.view();
  for (std::size_t begin = 0; begin < points_.size(); begin += kAtOnce) {
    moveSome(shape, begin, std::min(kAtOnce, points_.size() - begin));
  }
  for (std::size_t k = points_.size(); k < all.count; ++k) x_[k] = all.x[k], y_[k] = all.y[k], z_[k] = all.z[k];
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
