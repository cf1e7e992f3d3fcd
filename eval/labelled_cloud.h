// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What every method is given, and what is true about it.
#pragma once

#include <optional>
#include <vector>

#include "eval/metrics.h"
#include "eval/recipe.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::eval {

/// A shape that is there.
struct TrueShape {
  Shape shape;
  bool concave = false;  ///< seen from inside
  /// False: found or not, it counts neither way (too few pixels, also after thinning out, or concave where convex
  /// shapes are asked for).
  bool must = true;
  /// False: it stands for several surfaces that are nearly the same, and its numbers are those of one of them.
  bool exact = true;
  /// Of what is seen of it, where the simulation tells (depth frames, exact shapes).
  std::optional<Extent> seen = std::nullopt;
};

constexpr int kNoShape = -1, kClutter = -2;

/// One cloud with its truth.
struct LabelledCloud {
  Recipe recipe;
  Cloud cloud;               ///< as a detector gets it: depth frames without normals, everything else with them
  bool from_sensor = false;  ///< a depth frame: seen from the origin along z
  /// What results are scored on, with normals: all points even if the detector gets a part of them, without noise where
  /// it says so in data_sets.h.
  Cloud scored;
  std::vector<TrueShape> truth;  ///< the shapes that own points
  /// Index in truth of the shape of each scored point; kNoShape: of none; kClutter: of a surface that is none of the
  /// four kinds. Shapes have no end, so they run through such surfaces too: their points are nobody's, but a detection
  /// of nothing else is noise.
  std::vector<int> surface;
  /// Number of the face of each scored point whose true shape stands for several (TrueShape::exact), kNoShape for all
  /// others. Empty: no shape does.
  std::vector<int> face;
  double unit = 1.0;  ///< m, DOD is given in multiples of it: the noise, or 1 mm for depth frames
  Rules rules;        ///< how results on it are scored
};

/// A detector gets the points that are scored, in their order.
inline bool isPointByPoint(const LabelledCloud& input) {
  return input.cloud.size() == input.scored.size() && !input.recipe.shuffle;
}

}  // namespace primitect::eval
