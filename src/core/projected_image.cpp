// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Projection with the nearer point in front; see projected_image.h.
#include "core/projected_image.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

/// Bounds of x/z and y/z; in front: no camera sees more.
struct View {
  float left, right, top, bottom;
  bool in_front = false;
};

View viewOf(const Cloud& cloud) {
  constexpr float kWidest = 2.0f;  // tangent: beyond it no camera sees
  constexpr std::size_t kAtOnce = 8;
  const float *const x = cloud.x.data(), *const y = cloud.y.data(), *const z = cloud.z.data();
  float left[kAtOnce], right[kAtOnce], top[kAtOnce], bottom[kAtOnce];
  for (std::size_t lane = 0; lane < kAtOnce; ++lane) left[lane] = top[lane] = 1e9f, right[lane] = bottom[lane] = -1e9f;
  const auto look = [&](std::size_t i, std::size_t lane) {
    // Missing points are NaN, of which no comparison holds.
    const float u = x[i] / z[i], v = y[i] / z[i];
    left[lane] = u < left[lane] ? u : left[lane], right[lane] = u > right[lane] ? u : right[lane];
    top[lane] = v < top[lane] ? v : top[lane], bottom[lane] = v > bottom[lane] ? v : bottom[lane];
  };
  std::size_t i = 0;
  for (; i + kAtOnce <= cloud.size(); i += kAtOnce) {
    for (std::size_t lane = 0; lane < kAtOnce; ++lane) look(i + lane, lane);
  }
  for (; i < cloud.size(); ++i) look(i, 0);
  View view = {*std::min_element(left, left + kAtOnce), *std::max_element(right, right + kAtOnce),
               *std::min_element(top, top + kAtOnce), *std::max_element(bottom, bottom + kAtOnce)};
  view.in_front = cloud.behind_count == 0 && -kWidest < view.left && view.right < kWidest && -kWidest < view.top &&
                  view.bottom < kWidest;
  return view;
}

}  // namespace

/// Returns how many points lie in a pixel with one of another surface.
std::size_t ProjectedImage::project(const Cloud& cloud, float left, float top, float pitch) {
  constexpr float kOtherSurface = 0.1f;  // of the depth
  // Times the depth: of two points this near each other the first one stays. The nearer one would be the one that noise
  // moved towards the sensor.
  constexpr float kSameSurface = 1.02f;
  pixel_.assign(cloud.size(), 0);
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const auto column = static_cast<std::uint32_t>((cloud.x[i] / cloud.z[i] - left) / pitch);
    const auto row = static_cast<std::uint32_t>((cloud.y[i] / cloud.z[i] - top) / pitch);
    const std::uint32_t pixel = std::min(row, image_.height - 1) * image_.width + std::min(column, image_.width - 1);
    pixel_[i] = pixel;
    const float there = image_.z[pixel];
    if (std::fabs(there - cloud.z[i]) > kOtherSurface * cloud.z[i]) ++hidden;
    if (there <= kSameSurface * cloud.z[i]) continue;  // NaN, an empty pixel, does not hold
    if (!image_.valid(pixel)) ++image_.valid_count;
    image_.x[pixel] = cloud.x[i], image_.y[pixel] = cloud.y[i], image_.z[pixel] = cloud.z[i];
  }
  return hidden;
}

bool ProjectedImage::make(const Cloud& cloud) {
  constexpr double kMostHidden = 0.05, kLeastKept = 0.5;  // of the points
  constexpr int kTimes = 3;
  if (cloud.organized() || cloud.behind_count > 0) return false;
  const View view = viewOf(cloud);
  const float width = view.right - view.left, height = view.bottom - view.top;
  if (!view.in_front || !(width > 0.0f && height > 0.0f)) return false;
  const float points = static_cast<float>(cloud.valid_count), most_pixels = std::max(8.0f * points, 1048576.0f);
  float pitch = std::sqrt(width * height / points);
  for (int time = 0; time < kTimes; ++time) {
    const float columns = std::floor(width / pitch) + 1.0f, rows = std::floor(height / pitch) + 1.0f;
    // Points along a line fill no image.
    if (!(columns * rows < most_pixels && columns < points && rows < points)) return false;
    image_.reset(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), false);
    const std::size_t hidden = project(cloud, view.left, view.top, pitch);
    const double kept = static_cast<double>(image_.valid_count) / cloud.valid_count;
    if (kept >= kLeastKept) return static_cast<double>(hidden) <= kMostHidden * cloud.valid_count;
    // Most of what is in view is empty: a few points far from all others, say.
    pitch *= static_cast<float>(std::sqrt(kept));
  }
  return false;
}

}  // namespace primitect
