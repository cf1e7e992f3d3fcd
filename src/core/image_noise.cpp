// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Windows and their quartile; see image_noise.h.
#include "core/image_noise.h"

#include <algorithm>
#include <cmath>

#include "core/frame_memory.h"
#include "core/lower_quartile.h"
#include "core/window_normal.h"

namespace primitect {

ImageNoise measureImageNoise(const Cloud& image, NormalSource& source, const Samples& samples) {
  // Neighbouring pixels err alike: in windows as small as those of normals two thirds of the noise of real cameras
  // show. Grains are as many pixels wide in coarse images, too: in smaller windows they go with the parabola.
  constexpr int kUsualHalfWidth = 12, kSmallest = 4;  // px
  constexpr std::size_t kWindows = 48, kFewest = 12;
  const double share = shareOfUsualWindows(raysOf(image, source));
  const int half_width = std::max(static_cast<int>(std::lround(kUsualHalfWidth * share)), kSmallest);
  const PixelPitch& pitch = pixelPitch(image, source);
  List<double> deviations, likenesses;
  for (std::size_t i = 0; i < samples.size(); i += samples.size() / kWindows + 1) {
    const auto noise = windowNoise(image, samples.index[i], half_width, pitch);
    if (noise) deviations.push_back(noise->deviation);
    const bool usual = half_width == kUsualHalfWidth;
    const auto wide = usual ? noise : windowNoise(image, samples.index[i], kUsualHalfWidth, pitch);
    if (wide && wide->likeness) likenesses.push_back(*wide->likeness);
  }
  ImageNoise result;
  if (deviations.size() >= kFewest) result.scale = lowerQuartile(deviations);
  if (likenesses.size() >= kFewest) result.likeness = median(likenesses);
  return result;
}

double grainOf(const ImageNoise& noise) {
  constexpr double kUsual = 0.45, kPerPixel = 1.0 / 60.0, kMost = 7.0;
  return std::clamp(1.0 + (noise.likeness - kUsual) / kPerPixel, 1.0, kMost);
}

}  // namespace primitect
