// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures on the points of one cloud: who they belong to, coverage, DOD.
#pragma once

#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::eval {

/// Tolerances of the scoring.
struct Rules {
  double max_distance = 0.05;   ///< m, a point belongs to the closest shape within this ...
  double max_angle_deg = 15.0;  ///< ... whose normal agrees within this, sign ignored
  double overlap = 0.6;         ///< T of SegComp, above 0.5 so that correct pairs are unique
};

/// The shape that each point belongs to: index of the closest one that passes the rules, -1: none. Missing points and
/// points without normal belong to none. Throws std::invalid_argument for a cloud without normals and for rules out of
/// range.
std::vector<int> assign(const Cloud& cloud, const std::vector<Shape>& shapes, const Rules& rules);

/// How far points are from shapes, m.
struct Distances {
  std::vector<float> closest;  ///< of all shapes, whatever the normal; infinite without shapes, NaN of a missing point
  std::vector<float> own;      ///< the shape that the point belongs to; NaN when it is missing or belongs to none
};

/// labels: of assign(). Throws std::invalid_argument when their number is not that of the points.
Distances measureDistances(const Cloud& cloud, const std::vector<Shape>& shapes, const std::vector<int>& labels);

/// DOD in m: mean distance between the projections of the points with this label onto two shapes (paper, Evaluation
/// metrics); 0 without such points.
double objectDistance(const Cloud& cloud, const std::vector<int>& labels, int label, const Shape& truth,
                      const Shape& found);

/// p-coverage (paper, Evaluation metrics): for each epsilon (m, rising) the share of the points nearer than it to any
/// detection. Missing points do not count; without points 0.
std::vector<double> pointCoverage(const Distances& distances, const std::vector<double>& epsilons);

/// s-coverage (paper): for each epsilon (m, rising) the mean over the detections of the share of their own points
/// nearer than it. Detections without points are left out; without any: empty.
std::vector<double> shapeCoverage(const Distances& distances, const std::vector<int>& labels, std::size_t detections,
                                  const std::vector<double>& epsilons);

}  // namespace primitect::eval
