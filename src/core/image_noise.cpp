// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Windows and their quartile; see image_noise.h.
#include "core/image_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/frame_memory.h"
#include "core/lower_quartile.h"
#include "core/noise.h"
#include "core/ramp.h"
#include "core/window_normal.h"

namespace primitect {
namespace {

constexpr double kMostGrain = 7.0;  // px

/// Depth, and noise there in standard deviations of axialNoise().
using NoiseAtDepths = List<std::pair<double, double>>;

/// Of the places [begin, end): many hold edges and what is rough.
double noiseOf(const NoiseAtDepths& places, std::size_t begin, std::size_t end) {
  List<double> noise;
  for (std::size_t k = begin; k < end; ++k) noise.push_back(places[k].second);
  return lowerQuartile(noise);
}

/// How many times as noisy the farther half is as the nearer one; 1 where the places are few, lie about as far away or
/// have no noise.
double fartherOverNearer(NoiseAtDepths& places) {
  constexpr std::size_t kFewest = 24;
  constexpr double kApart = 1.25;
  if (places.size() < kFewest) return 1.0;
  std::sort(places.begin(), places.end());
  const std::size_t middle = places.size() / 2;
  if (!(places[(middle + places.size()) / 2].first > kApart * places[middle / 2].first)) return 1.0;
  const double near = noiseOf(places, 0, middle);
  return near > 0.0 ? noiseOf(places, middle, places.size()) / near : 1.0;
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
  List<double> likenesses;
  NoiseAtDepths places;
  for (std::size_t i = 0; i < samples.size(); i += samples.size() / kWindows + 1) {
    const auto noise = windowNoise(image, samples.index[i], half_width, pitch);
    if (noise) places.emplace_back(static_cast<double>(samples.z[i]), noise->deviation);
    const bool usual = half_width == kUsualHalfWidth;
    const auto wide = usual ? noise : windowNoise(image, samples.index[i], kUsualHalfWidth, pitch);
    if (wide && wide->likeness) likenesses.push_back(*wide->likeness);
  }
  ImageNoise result;
  result.farther = fartherOverNearer(places);
  if (places.size() >= kFewest) result.scale = noiseOf(places, 0, places.size());
  if (likenesses.size() >= kFewest) result.likeness = median(likenesses);
  return result;
}

double grainOf(const ImageNoise& noise) {
  constexpr double kUsual = 0.45, kPerPixel = 1.0 / 60.0;
  return std::clamp(1.0 + (noise.likeness - kUsual) / kPerPixel, 1.0, kMostGrain);
}

double usualGrainOf(const ImageNoise& noise) {
  constexpr double kUsual = 2.5, kNotAlike = 0.15, kAlike = 0.3;
  return 1.0 + (kUsual - 1.0) * ramp(kNotAlike, kAlike, noise.likeness);
}

double steadyingOf(const ImageNoise& noise) {
  const bool known = noise.likeness != 0.0;
  // Of pixels that share more of it than is usual the mean has hardly less.
  if (!known || grainOf(noise) > 1.0) return 0.0;
  return 1.0 - kNoisy / std::max(noise.scale, kNoisy);
}

double noiseOfSteadied(const ImageNoise& noise, double steadying) {
  // Correlation of pixels two apart that share all of it, as a stereo camera's. The smallest means are of 9 pixels.
  constexpr double kAllShared = 0.64, kLeast = 1.0 / 9.0;
  const double shared = std::clamp(noise.likeness / kAllShared, kLeast, 1.0);
  const double own = (1.0 - steadying) * (1.0 - steadying);
  return noise.scale * std::sqrt(own + (1.0 - own) * shared);
}

double growthOf(const ImageNoise& noise) {
  constexpr double kMost = 0.8;
  constexpr double kAsUsual = 1.2, kClearly = 1.5;  // of noise in grains that grows as structured light's: 1.1
  return 1.0 + kMost * (grainOf(noise) - 1.0) / (kMostGrain - 1.0) * ramp(kAsUsual, kClearly, noise.farther);
}

}  // namespace primitect
