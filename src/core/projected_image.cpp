// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Projection with the nearer point in front; see projected_image.h.
#include "core/projected_image.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

/// Bounds of x/z and y/z; empty when a point is not in front.
struct View {
  float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
  bool in_front = true;
};

View viewOf(const Cloud& cloud) {
  constexpr float kWidest = 2.0f;  // tangent: beyond it no camera sees
  View view;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const float u = cloud.x[i] / cloud.z[i], v = cloud.y[i] / cloud.z[i];
    view.in_front = view.in_front && cloud.z[i] > 0.0f && std::fabs(u) < kWidest && std::fabs(v) < kWidest;
    view.left = std::min(view.left, u), view.right = std::max(view.right, u);
    view.top = std::min(view.top, v), view.bottom = std::max(view.bottom, v);
  }
  return view;
}

}  // namespace

std::optional<ProjectedImage> projectedImage(const Cloud& cloud) {
  constexpr float kOtherSurface = 0.1f;  // of the depth
  constexpr double kMostHidden = 0.05;   // of the points
  const View view = viewOf(cloud);
  const float width = view.right - view.left, height = view.bottom - view.top;
  if (cloud.organized() || !view.in_front || !(width > 0.0f && height > 0.0f)) return std::nullopt;
  const float pitch = std::sqrt(width * height / static_cast<float>(cloud.valid_count));
  ProjectedImage projected;
  const auto columns = static_cast<std::uint32_t>(width / pitch) + 1,
             rows = static_cast<std::uint32_t>(height / pitch) + 1;
  projected.image.reset(columns, rows, false);
  projected.pixel.assign(cloud.size(), 0);
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const auto column = static_cast<std::uint32_t>((cloud.x[i] / cloud.z[i] - view.left) / pitch);
    const auto row = static_cast<std::uint32_t>((cloud.y[i] / cloud.z[i] - view.top) / pitch);
    const std::uint32_t pixel = std::min(row, rows - 1) * columns + std::min(column, columns - 1);
    projected.pixel[i] = pixel;
    const float there = projected.image.z[pixel];
    if (std::fabs(there - cloud.z[i]) > kOtherSurface * cloud.z[i]) ++hidden;
    if (there <= cloud.z[i]) continue;  // NaN, an empty pixel, does not hold
    if (!projected.image.valid(pixel)) ++projected.image.valid_count;
    projected.image.x[pixel] = cloud.x[i], projected.image.y[pixel] = cloud.y[i], projected.image.z[pixel] = cloud.z[i];
  }
  if (static_cast<double>(hidden) > kMostHidden * cloud.valid_count) return std::nullopt;
  return projected;
}

}  // namespace primitect
