// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What every method is given, and what is true about it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/metrics.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::eval {

/// What a cloud of a data set is made with. Values that a set does not know are left at their default.
struct Recipe {
  std::string set = "paper-mixed";  ///< one of dataSetNames()
  std::uint64_t seed = 1;
  double sigma = 0.01;       ///< m, noise of the paper's sets; of the parts the half width of the uniform noise
  double noise_scale = 1.0;  ///< times the noise of the simulated depth sensor
  double outliers = 0.0;     ///< share of points thrown anywhere into the bounding box, [0, 1)
  double keep = 1.0;         ///< share of the points that is kept, drawn at random, (0, 1]
};

/// A shape that is there.
struct TrueShape {
  Shape shape;
  bool concave = false;  ///< seen from inside
  /// False: found or not, it counts neither way (too few pixels, or concave where convex shapes are asked for).
  bool must = true;
};

constexpr int kNoShape = -1, kClutter = -2;

/// One cloud with its truth.
struct LabelledCloud {
  Recipe recipe;
  Cloud cloud;  ///< as a detector gets it: organized without normals, or unorganized with normals
  /// What results are scored on, with normals: all points even if the detector gets a part of them, without noise where
  /// it says so in data_sets.h.
  Cloud scored;
  std::vector<TrueShape> truth;  ///< the shapes that own points
  /// Index in truth of the shape of each scored point; kNoShape: of none; kClutter: of a surface that is none of the
  /// four kinds. Shapes have no end, so they run through such surfaces too: their points are nobody's, but a detection
  /// of nothing else is noise.
  std::vector<int> surface;
  double unit = 1.0;  ///< m, DOD is given in multiples of it: the noise, or 1 mm for depth frames
  Rules rules;        ///< how results on it are scored
};

}  // namespace primitect::eval
