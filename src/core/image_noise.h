// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How much noisier a depth image is than one of structured light.
#pragma once

#include "core/normals.h"
#include "core/samples.h"
#include "primitect/cloud.h"

namespace primitect {

struct ImageNoise {
  /// How far points stray from surfaces, in standard deviations of axialNoise(), up to about five; six at most. 0: not
  /// measured.
  double scale = 0.0;
  double likeness = 0.0;  ///< correlation of the errors of pixels two apart
};

/// From surfaces that are fitted to windows around some of the samples: of the deviations in all windows the lower
/// quartile, as many hold edges and what is rough, of the correlations the median. Not measured where fewer than a
/// dozen can be fitted.
ImageNoise measureImageNoise(const Cloud& image, NormalSource& source, const Samples& samples);

/// So many by so many pixels share their noise, as of a block matcher: 1 of other cameras, at most 7. Pixels two apart
/// of recorded structured light and time of flight have the correlation .35 to .48, which is usual, of recorded stereo
/// .66; of simulated noise in grains of 5, 7, 9 px .50, .57, .60.
double grainOf(const ImageNoise& noise);

}  // namespace primitect
