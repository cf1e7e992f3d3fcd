// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Distances to the curved shape beside those to the plane; see curved_patch.h.
#include "core/curved_patch.h"

#include <cmath>

#include "core/observed_part.h"

namespace primitect {
namespace {

/// Of some of the pixels, spread evenly.
bool liesOn(const Detection& curved, const List<std::uint32_t>& pixels, const Cloud& image, const NoiseModel& noise) {
  constexpr std::size_t kAsked = 256;
  constexpr double kMostBeside = 0.1;
  const std::size_t step = pixels.size() / kAsked + 1, asked = (pixels.size() + step - 1) / step;
  const auto most_beside = static_cast<std::size_t>(kMostBeside * static_cast<double>(asked));
  const ObservedPart part(curved.shape, curved.extent);
  std::size_t beside = 0;
  for (std::size_t k = 0; k < pixels.size() && beside <= most_beside; k += step) {
    const Vec3 point = image.point(pixels[k]);
    const double near = kInlierDeviations * noise.at(point);
    const std::uint32_t i = pixels[k];
    const bool on = std::abs(distance(curved.shape, point)) < near &&
                    part.holds(image.x[i], image.y[i], image.z[i], static_cast<float>(near));
    beside += on ? 0 : 1;
  }
  return asked > 0 && beside <= most_beside;
}

}  // namespace

bool isPatchOf(const Labelled<Detection>& curved, const Labelled<Plane>& plane, const List<std::uint32_t>& pixels,
               const Cloud& image, const std::vector<std::uint32_t>& labels, const NoiseModel& noise) {
  constexpr double kMostTimes = 1.4;
  if (!liesOn(curved.shape, pixels, image, noise)) return false;
  double to_curved = 0.0, to_plane = 0.0;
  for (std::size_t k = 0; k + 1 < pixels.size(); ++k) {
    const bool same_row = pixels[k] / image.width == pixels[k + 1] / image.width;
    const std::uint32_t end = same_row ? pixels[k + 1] : pixels[k] + 1;
    for (std::uint32_t i = pixels[k]; i < end; ++i) {
      if (labels[i] != plane.label && labels[i] != curved.label) continue;
      const double away = distance(curved.shape.shape, image.point(i)), above = distance(plane.shape, image.point(i));
      to_curved += away * away;
      to_plane += above * above;
    }
  }
  return to_curved < kMostTimes * to_plane;
}

}  // namespace primitect
