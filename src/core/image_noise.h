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
  double farther = 1.0;   ///< the same of the farther half of the image over that of the nearer half
  double likeness = 0.0;  ///< correlation of the errors of pixels two apart; 0: not measured
};

/// From surfaces that are fitted to windows around some of the samples: of the deviations in all windows the lower
/// quartile, as many hold edges and what is rough, of the correlations the median. Not measured where fewer than a
/// dozen windows tell.
ImageNoise measureImageNoise(const Cloud& image, NormalSource& source, const Samples& samples);

/// How many by how many pixels share their noise beyond what is usual of structured light and time of flight, whose
/// pixels two apart have a correlation of .35 to .45 in recordings (.48 in one): 1 up to there, 4 at .50, at most 7. Of
/// a recorded stereo camera it is .66; of three times the noise in simulated grains of 5, 7, 9 px .50, .57, .60.
double grainOf(const ImageNoise& noise);

/// The same of any real camera: 2.5 where pixels two apart err alike at all (correlation .3), as those of all recorded
/// cameras do; 1 where not (.15). Normals of recorded walls and tables err two to three times as far as they would if
/// pixels erred each for itself.
double usualGrainOf(const ImageNoise& noise);

/// How far samples go from their pixel to the mean of those around it (WindowNormal::point), from 0 to 1: until they
/// have no more noise than tolerances take as it is (kNoisy), if pixels err each for itself. 0 where they share more of
/// it than those of usual cameras, or where that is not known.
double steadyingOf(const ImageNoise& noise);

/// The noise of samples that went so far, in the unit of ImageNoise::scale: what pixels share stays in the mean.
double noiseOfSteadied(const ImageNoise& noise, double steadying);

/// How many times faster than that of structured light the noise of a stereo camera grows, for tolerances: up to 1.8
/// where pixels share their noise, which hides some of it, and the farther half of the image is the noisier one.
double growthOf(const ImageNoise& noise);

}  // namespace primitect
