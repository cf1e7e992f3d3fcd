// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How far measured points stray from the surface they were measured on, and their normals from its normal.
#pragma once

#include <algorithm>

#include "primitect/primitives.h"

namespace primitect {

/// Axial noise of structured-light cameras (m, one standard deviation) at depth z (Nguyen et al., 3DIMPVT 2012): the
/// least, at the nearest depth they measure, and its growth; others' may grow so many times as fast.
constexpr double kAxialLeast = 0.0012, kAxialNearest = 0.4, kAxialGrowth = 0.0019;
inline double axialNoise(double z, double growth = 1.0) {
  return kAxialLeast + growth * kAxialGrowth * (z - kAxialNearest) * (z - kAxialNearest);
}

struct NoiseModel {
  double distance = 0.0;     ///< m, one standard deviation of the distance to the surface, the same everywhere
  double depth_share = 0.0;  ///< above 0: a depth camera; then its axial noise, but at least this share of z
  double angle = 0.5;        ///< rad, a normal that is off by more is hardly noise, unless more of it is known
  double scale = 1.0;        ///< times the axial noise: of a depth camera that is noisier than structured light
  double growth = 1.0;       ///< times its growth with the depth
  double normals = 1.0;      ///< times the normal_sigma of samples: what pixels share is not in it
  /// rad, what normals may be off by that. With .5 clutter whose noise five pixels share carries twice as many curved
  /// shapes (compare --set clutter --noise-grain 5 --seeds 3000:60), with .23 fewer things are found in halls.
  double most_turn = 0.28;

  bool ofDepthCamera() const { return depth_share > 0.0; }

  /// One standard deviation (m) at this point.
  double at(const Vec3& point) const {
    if (!ofDepthCamera()) return distance;
    return std::max(scale * axialNoise(point.z(), growth), depth_share * point.z());
  }
};

/// Tolerances grow by so much of the noise, above the noise where they begin to.
constexpr double kTolerated = 0.7, kNoisy = 1.0 / kTolerated;

/// What is tolerated in an image that is so many times as noisy as structured light, and what is its noise, in the same
/// unit. Tolerances have room for half as much noise again, and in wider ones small things are lost. Measured on 40
/// tables (seed 2300) with 2, 3, 4 times the noise, without steady_points: of what is seen 93, 86, 75 % are found
/// instead of 90, 48, 38; with tolerances that grow like the noise 86, 72, 57. Surfaces lie better, by a sixth,
/// when they are fitted to their points with all of the noise, and their covariances are right.
inline double toleratedScale(double image_noise) { return std::max(1.0, kTolerated * image_noise); }
inline double fullScale(double image_noise) { return std::max(1.0, image_noise); }

struct Samples;

/// Fills sigma and what follows from it of the samples, whose normal_sigma is known.
void applyNoise(const NoiseModel& noise, Samples& samples);

/// A normal is hardly noise when it is off by this many standard deviations (about each axis).
constexpr double kNormalDeviations = 4.0;

/// A point farther than this many standard deviations from a shape is not its inlier.
constexpr double kInlierDeviations = 3.0;

}  // namespace primitect
