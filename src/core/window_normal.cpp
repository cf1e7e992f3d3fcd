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

kernels::WindowTask taskAt(std::uint32_t pixel, const Vec3& center, int half_width, const PixelPitch& pitch,
                           double noise_scale) {
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
  task.tolerance = static_cast<float>(kTolerance * noise_scale * axialNoise(center.z()) / center.z());
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

/// How far d of every second pixel in every second row strays from the plane.
double rmsError(const Cloud& image, const kernels::WindowTask& task, const kernels::WindowPlane& plane) {
  constexpr int kEvery = 2;
  const auto width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  const auto pixel = static_cast<int>(task.pixel), half = static_cast<int>(task.half_width);
  const int column = pixel % width, row = pixel / width;
  double squares = 0.0, count = 0.0;
  for (int v = std::max(row - half, 0); v <= std::min(row + half, height - 1); v += kEvery) {
    for (int u = std::max(column - half, 0); u <= std::min(column + half, width - 1); u += kEvery) {
      const int k = v * width + u;
      const double inverse = 1.0 / image.z[k];
      const double error = task.depth * inverse - 1.0 - plane.a * (image.x[k] * inverse - task.u) -
                           plane.b * (image.y[k] * inverse - task.v) - plane.c;
      if (!(std::abs(error) < task.tolerance)) continue;
      squares += error * error;
      count += 1.0;
    }
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

}  // namespace

std::optional<WindowNormal> windowNormal(const Cloud& cloud, std::uint32_t pixel, int half_width,
                                         const PixelPitch& pitch, double noise_scale) {
  const Vec3 center(cloud.x[pixel], cloud.y[pixel], cloud.z[pixel]);
  return windowNormal(cloud, pixel, center, half_width, pitch, noise_scale);
}

std::optional<WindowNormal> windowNormal(const Cloud& image, std::uint32_t pixel, const Vec3& center, int half_width,
                                         const PixelPitch& pitch, double noise_scale) {
  if (!(center.z() > 0.0)) return std::nullopt;
  const kernels::WindowTask task = taskAt(pixel, center, half_width, pitch, noise_scale);
  const kernels::PointImage points = {image.x.data(), image.y.data(), image.z.data(), image.width, image.height};
  const kernels::WindowPlane plane = kernels::loops().fitWindow(points, task);
  if (!usable(plane, task)) return std::nullopt;
  // 1/z = (a (u - task.u) + b (v - task.v) + c + 1) / depth is the plane n.p = 1 with this n times the depth.
  const Vec3 normal(plane.a, plane.b, 1.0 + plane.c - plane.a * task.u - plane.b * task.v);
  // a and b turn the plane; c is known much better.
  const double noise = noise_scale * axialNoise(center.z()) / center.z() * std::sqrt(plane.variance) / normal.norm();
  return WindowNormal{-normal.normalized(), noise};
}

std::optional<double> windowDeviation(const Cloud& image, std::uint32_t pixel, int half_width,
                                      const PixelPitch& pitch) {
  constexpr double kMostNoise = 4.0;  // what strays three standard deviations of it is another surface
  const Vec3 center(image.x[pixel], image.y[pixel], image.z[pixel]);
  if (!(center.z() > 0.0)) return std::nullopt;
  const kernels::WindowTask task = taskAt(pixel, center, half_width, pitch, kMostNoise);
  const kernels::PointImage points = {image.x.data(), image.y.data(), image.z.data(), image.width, image.height};
  const kernels::WindowPlane plane = kernels::loops().fitWindow(points, task);
  if (!usable(plane, task)) return std::nullopt;
  return rmsError(image, task, plane) * center.z() / axialNoise(center.z());
}

}  // namespace primitect
