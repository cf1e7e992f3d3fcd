// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The noise at each of many points.
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

#include "core/noise.h"
#include "core/seen_points.h"
#include "kernels/loops.h"

namespace primitect {

/// So many standard deviations (m) of the noise at each depth.
inline kernels::FlatTolerance flattened(const NoiseModel& noise, double deviations) {
  const auto scaled = [deviations](double value) { return static_cast<float>(deviations * value); };
  const auto nearest = static_cast<float>(kAxialNearest);
  if (!noise.ofDepthCamera()) return {scaled(noise.distance), 0.0f, nearest, 0.0f};
  return {scaled(noise.scale * kAxialLeast), scaled(noise.scale * noise.growth * kAxialGrowth), nearest,
          scaled(noise.depth_share)};
}

/// One standard deviation (m) of the distance to a surface: by a noise model, or any function of the point.
class PointNoise {
 public:
  PointNoise(const NoiseModel& noise) : noise_(noise) {}
  template <class Function, class = std::enable_if_t<std::is_invocable_r_v<double, Function, const Vec3&>>>
  PointNoise(Function function) : function_(std::move(function)) {}

  double operator()(const Vec3& point) const { return function_ ? function_(point) : noise_.at(point); }

  template <std::size_t most>
  void at(const SomePoints<most>& points, float* sigma) const {
    if (function_) {
      for (std::size_t k = 0; k < points.count; ++k) sigma[k] = static_cast<float>(function_(points.point(k)));
      return;
    }
    float depth[SomePoints<most>::kRoom];
    const auto origin = static_cast<float>(points.origin.z());
    for (std::size_t k = 0; k < points.count; ++k) depth[k] = origin + points.z[k];
    kernels::loops().tolerances(flattened(noise_, 1.0), depth, points.count, sigma);
  }

 private:
  NoiseModel noise_;
  std::function<double(const Vec3&)> function_;
};

}  // namespace primitect
