// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a depth camera makes of an exact depth image.
#pragma once

#include <cstdint>
#include <vector>

#include "synthetic/camera.h"

namespace primitect::synthetic {

/// The sensor's faults: by default those of structured light; of others in sensors.h. Each can be switched off alone.
struct NoiseParams {
  double scale = 1.0;  ///< times the noise; 0 = off
  int grain = 1;       ///< px, odd: so many by so many pixels share noise of that strength, as of a block matcher
  /// px, standard deviation of the disparity, that of the depth is this times z^2 / (fx * baseline); 0 = axialSigma()
  double disparity_noise = 0.0;
  /// px, standard deviation of where a pixel measures, to the side: that much more depth noise where a surface is
  /// slanted
  double sideways = 0.0;
  double baseline = 0.075;          ///< between projector, or second camera, and camera, m
  double disparity_step = 0.125;    ///< px; disparities are multiples of it; 0 = off
  int footprint = 1;                ///< px, odd: a pixel measures the mean over so many by so many (mixNeighbors)
  bool shadows = false;             ///< what the projector or second camera does not see is lost (removeShadows)
  double waves = 0.0;               ///< share of the depth, standard deviation of what a poor calibration leaves (bend)
  int wave_length = 41;             ///< px, odd
  double blots = 0.0;               ///< share of the pixels that are lost (removeBlots), as on dark and glossy surfaces
  int blot_grain = 9;               ///< px, odd
  double max_incidence_deg = 80.0;  ///< surfaces slanted more, and depth steps that look like it, are lost; 90 = off
  double min_depth = 0.4;           ///< m; nearer pixels are lost; 0 = off
  double max_depth = 4.0;           ///< m; farther pixels are lost; 0 = off
};

/// Standard deviation of the depth (m) at depth z (m): 0.0012 + 0.0019 (z - 0.4)^2
/// (Nguyen, Izadi, Lovell: Modeling Kinect Sensor Noise, 3DIMPVT 2012).
double axialSigma(double z);

/// The depth nearest to z (m) in disparity d = fx * baseline / z that is a multiple of disparity_step.
/// At 1 m the depths are 2.9 mm apart, at 2 m 12 mm. NaN when the disparity rounds to 0.
double quantizedDepth(double z, const NoiseParams& params, double fx);

/// Turns exact depth (m, NaN = missing) into measured depth, in place. A pixel is lost
///  - when the surface towards one of its four neighbours is slanted by more than max_incidence_deg. A depth step
///    between neighbours is such a slant too (at 1 m: a step of 1 cm), so both sides of an edge go;
///  - when its neighbour saw nothing;
///  - when its depth, exact or measured, is outside min_depth..max_depth;
///  - in shadows and blots, where params have any.
/// Depends on (seed, frame_index) only, waves on seed only; without grain and sideways errors, a pixel's noise does not
/// depend on the other pixels. With it, the noise of pixels d columns apart has the correlation 1 - d / grain. Throws
/// std::invalid_argument when a parameter is out of its range or depth does not have the camera's size.
void addNoise(const NoiseParams& params, const PinholeCamera& camera, std::uint64_t seed, std::uint64_t frame_index,
              std::vector<float>& depth);

}  // namespace primitect::synthetic
