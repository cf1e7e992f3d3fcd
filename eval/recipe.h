// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a cloud of a data set is made with.
#pragma once

#include <cstdint>
#include <string>

namespace primitect::eval {

/// Values that a set does not use are left at their default.
struct Recipe {
  std::string set = "paper-mixed";  ///< one of dataSetNames()
  std::uint64_t seed = 1;
  double sigma = 0.01;       ///< m, noise of the paper's sets; of the parts the half width of the uniform noise
  double noise_scale = 1.0;  ///< times the noise of the simulated depth sensor
  std::string sensor = "structured_light";  ///< of depth frames, one of synthetic::sensorNames()
  int noise_grain = 1;    ///< px, odd, 1 to 31: so many by so many pixels share that noise; 1: as of the sensor
  double blots = 0.0;     ///< share of the pixels of depth frames that are lost in blots of 9 px, [0, 1)
  int width = 640;        ///< columns of the depth frames, 4 : 3, [160, 2560]
  double outliers = 0.0;  ///< share of points thrown anywhere into the bounding box, [0, 1)
  double keep = 1.0;      ///< share of the points that is kept, drawn at random, (0, 1]
  double uneven = 1.0;    ///< from one side of the cloud to the other this many times fewer points, [1, 1000]
  double voxel = 0.0;     ///< m: a point for each cube of that side, the mean of those in it; 0: all points
  bool listed = false;    ///< the measured points alone, in their order, unorganized
  bool shuffle = false;   ///< in random order, unorganized
  /// Points and truth in a frame on the floor below the sensor: x ahead, y to the left, z up, the sensor 1.3 m above
  /// the origin and turned 38 deg down.
  bool robot_frame = false;
};

/// The set shows a room as a depth camera sees it.
bool isDepthFrame(const std::string& set);

/// Which of the values a set uses; every set knows keep, uneven, listed, shuffle and robot_frame.
struct UsedBySet {
  bool sigma, depth_frame, outliers;
};
UsedBySet usedBySet(const std::string& set);

/// Throws std::invalid_argument for a value out of range and for one that the set does not use, naming set, value and
/// range. Sigma is checked by the sets that use it.
void checkRecipe(const Recipe& recipe);

/// "sigma 0.01, outliers 0.3, shuffled": what the set uses, variants only where they were asked for. Without the seed.
std::string describe(const Recipe& recipe);

}  // namespace primitect::eval
