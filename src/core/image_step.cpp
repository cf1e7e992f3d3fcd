// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Bounds of what is left of a large image; see image_step.h.
#include "primitect/image_step.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

constexpr double kEnoughPixels = 640.0 * 360.0, kEnoughPoints = 131072.0;
constexpr std::uint32_t kEnoughLines = 240;

}  // namespace

int largestImageStep(std::uint32_t width, std::uint32_t height) {
  const double by_pixels = std::sqrt(static_cast<double>(width) * height / kEnoughPixels);
  const std::uint32_t by_lines = std::min(width, height) / kEnoughLines;
  return std::max(1, static_cast<int>(std::min(by_pixels, static_cast<double>(by_lines))));
}

int imageStepFor(int step, std::size_t measured) {
  const double share = static_cast<double>(measured) / kEnoughPoints;
  if (step <= 1 || share >= 1.0) return step;
  return std::max(1, static_cast<int>(step * std::sqrt(share)));
}

}  // namespace primitect
