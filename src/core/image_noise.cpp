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

double measureImageNoise(const Cloud& image, NormalSource& source, const Samples& samples) {
  // Neighbouring pixels err alike: in windows as small as those of normals two thirds of the noise of real cameras
  // show.
  constexpr double kUsualHalfWidth = 12.0, kSmallest = 4.0;  // px
  constexpr std::size_t kWindows = 48, kFewest = 12;
  const double half_width = std::max(kUsualHalfWidth * shareOfUsualWindows(raysOf(image, source)), kSmallest);
  const PixelPitch& pitch = pixelPitch(image, source);
  List<double> deviations;
  for (std::size_t i = 0; i < samples.size(); i += samples.size() / kWindows + 1) {
    const auto deviation = windowDeviation(image, samples.index[i], static_cast<int>(std::lround(half_width)), pitch);
    if (deviation) deviations.push_back(*deviation);
  }
  return deviations.size() < kFewest ? 0.0 : lowerQuartile(deviations);
}

}  // namespace primitect
