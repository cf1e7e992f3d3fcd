// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Windows and their quartile; see image_noise.h.
#include "core/image_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/frame_memory.h"
#include "core/lower_quartile.h"
#include "core/ramp.h"
#include "core/window_normal.h"

namespace primitect {
namespace {

/// How many times as noisy, in standard deviations of axialNoise(), the farther half of some places (depth, noise) is
/// as the nearer one; 1 where they are few, lie about as far away or have no noise.
double fartherOverNearer(List<std::pair<double, double>>& places) {
  constexpr std::size_t kFewest = 24;
  constexpr double kApart = 1.25;
  if (places.size() < kFewest) return 1.0;
  std::sort(places.begin(), places.end());
  const std::size_t middle = places.size() / 2;
  if (!(places[(middle + places.size()) / 2].first > kApart * places[middle / 2].first)) return 1.0;
  List<double> near, far;
  for (std::size_t k = 0; k < places.size(); ++k) (k < middle ? near : far).push_back(places[k].second);
  const double least = lowerQuartile(near);
  return least > 0.0 ? lowerQuartile(far) / least : 1.0;
}

}  // namespace

ImageNoise measureImageNoise(const Cloud& image, NormalSource& source, const Samples& samples) {
  // Neighbouring pixels err alike: in windows as small as those of normals two thirds of the noise of real cameras
  // show. Grains are as many pixels wide in coarse images, too: in smaller windows they go with the parabola.
  constexpr int kUsualHalfWidth = 12, kSmallest = 4;  // px
  constexpr std::size_t kWindows = 48, kFewest = 12;
  const double share = shareOfUsualWindows(raysOf(image, source));
  const int half_width = std::max(static_cast<int>(std::lround(kUsualHalfWidth * share)), kSmallest);
  const PixelPitch& pitch = pixelPitch(image, source);
  List<double> deviations, likenesses;
  List<std::pair<double, double>> places;
  for (std::size_t i = 0; i < samples.size(); i += samples.size() / kWindows + 1) {
    const auto noise = windowNoise(image, samples.index[i], half_width, pitch);
    if (noise) {
      deviations.push_back(noise->deviation);
      places.emplace_back(static_cast<double>(samples.z[i]), noise->deviation);
    }
    const bool usual = half_width == kUsualHalfWidth;
    const auto wide = usual ? noise : windowNoise(image, samples.index[i], kUsualHalfWidth, pitch);
    if (wide && wide->likeness) likenesses.push_back(*wide->likeness);
  }
  ImageNoise result;
  result.farther = fartherOverNearer(places);
  if (deviations.size() >= kFewest) result.scale = lowerQuartile(deviations);
  if (likenesses.size() >= kFewest) result.likeness = median(likenesses);
  return result;
}

double grainOf(const ImageNoise& noise) {
  constexpr double kUsual = 0.45, kPerPixel = 1.0 / 60.0, kMost = 7.0;
  return std::clamp(1.0 + (noise.likeness - kUsual) / kPerPixel, 1.0, kMost);
}

double growthOf(const ImageNoise& noise) {
  constexpr double kMost = 0.8, kMostGrain = 7.0;
  constexpr double kAsUsual = 1.2, kClearly = 1.5;  // of noise in grains that grows as structured light's: 1.1
  return 1.0 + kMost * (grainOf(noise) - 1.0) / (kMostGrain - 1.0) * ramp(kAsUsual, kClearly, noise.farther);
}

}  // namespace primitect
