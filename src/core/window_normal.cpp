// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What makes a fitted window a normal; see window_normal.h. The fit itself is kernels/window_loops.inc.
#include "core/window_normal.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "kernels/loops.h"

namespace primitect {
namespace {

constexpr double kTolerance = 3.0;  // standard deviations

kernels::WindowTask taskAt(std::uint32_t pixel, const Vec3& center, int half_width, const PixelPitch& pitch) {
  // Of d (window_loops.inc), nearly a share of the depth: more is another surface, at any slope that can be fitted.
  constexpr float kLargestJump = 0.04f;
  constexpr int kFewestAtStart = 6;
  kernels::WindowTask task = {};
  task.pixel = pixel;
  task.half_width = std::min(static_cast<std::size_t>(half_width), kernels::kLargestHalfWidth);
  task.inner_half_width = (task.half_width + 1) / 2;
  task.depth = static_cast<float>(center.z());
  task.u = static_cast<float>(center.x() / center.z());
  task.v = static_cast<float>(center.y() / center.z());
  task.largest_jump = kLargestJump;
  task.tolerance = static_cast<float>(kTolerance * axialNoise(center.z()) / center.z());
  task.fewest_at_start = kFewestAtStart;
  task.u_per_column = static_cast<float>(pitch.u);
  task.v_per_row = static_cast<float>(pitch.v);
  return task;
}

/// Holds the centre's surface, of enough pixels.
bool usable(const kernels::WindowPlane& plane, const kernels::WindowTask& task) {
  constexpr double kSmallestShare = 0.25;  // of the window, on the centre's surface
  const double width = 2.0 * static_cast<double>(task.half_width) + 1.0;
  const int needed = std::max(6, static_cast<int>(kSmallestShare * width * width));
  return plane.used >= needed && std::abs(plane.c) < static_cast<double>(task.tolerance);
}

}  // namespace

std::optional<WindowNormal> windowNormal(const Cloud& cloud, std::uint32_t pixel, int half_width,
                                         const PixelPitch& pitch) {
  return windowNormal(cloud, pixel, Vec3(cloud.x[pixel], cloud.y[pixel], cloud.z[pixel]), half_width, pitch);
}

std::optional<WindowNormal> windowNormal(const Cloud& image, std::uint32_t pixel, const Vec3& center, int half_width,
                                         const PixelPitch& pitch) {
  if (!(center.z() > 0.0)) return std::nullopt;
  const kernels::WindowTask task = taskAt(pixel, center, half_width, pitch);
  const kernels::PointImage points = {image.x.data(), image.y.data(), image.z.data(), image.width, image.height};
  const kernels::WindowPlane plane = kernels::loops().fitWindow(points, task);
  if (!usable(plane, task)) return std::nullopt;
  // 1/z = (a (u - task.u) + b (v - task.v) + c + 1) / depth is the plane n.p = 1 with this n times the depth.
  const Vec3 normal(plane.a, plane.b, 1.0 + plane.c - plane.a * task.u - plane.b * task.v);
  // a and b turn the plane; c is known much better.
  const double noise = axialNoise(center.z()) / center.z() * std::sqrt(plane.variance) / normal.norm();
  return WindowNormal{-normal.normalized(), noise};
}

}  // namespace primitect
