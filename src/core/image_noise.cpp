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
  // show.
  constexpr double kUsualHalfWidth = 12.0, kSmallest = 4.0;  // px
  constexpr std::size_t kWindows = 48, kFewest = 12;
  const double half_width = std::max(kUsualHalfWidth * shareOfUsualWindows(raysOf(image, source)), kSmallest);
  const PixelPitch& pitch = pixelPitch(image, source);
  List<double> deviations, correlations;
  for (std::size_t i = 0; i < samples.size(); i += samples.size() / kWindows + 1) {
    const auto noise = windowNoise(image, samples.index[i], static_cast<int>(std::lround(half_width)), pitch);
    if (!noise) continue;
    deviations.push_back(noise->deviation);
    correlations.push_back(noise->likeness);
  }
  if (deviations.size() < kFewest) return {};
  const auto middle = correlations.begin() + static_cast<std::ptrdiff_t>(correlations.size() / 2);
  std::nth_element(correlations.begin(), middle, correlations.end());
  return {lowerQuartile(deviations), *middle};
}

double grainOf(const ImageNoise& noise) {
  constexpr double kUsual = 0.45, kPerPixel = 1.0 / 60.0, kMost = 7.0;
  return std::clamp(1.0 + (noise.likeness - kUsual) / kPerPixel, 1.0, kMost);
}

}  // namespace primitect
