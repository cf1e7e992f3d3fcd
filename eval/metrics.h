// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scores of one scene, the same for every method: SegComp (Hoover et al. 1996), DOD, p-coverage and s-coverage.
#pragma once

#include <utility>
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

/// Where a point belongs.
struct Assignment {
  std::vector<int> shape;       ///< index of the closest shape that passes the rules, -1: none
  std::vector<float> distance;  ///< m, to the closest of all shapes, whatever the normal; infinite without shapes
};

/// Assigns every point of the cloud. Missing points belong to nothing, at an infinite distance; so do, for the shape
/// only, points without normal. Throws std::invalid_argument for a cloud without normals.
Assignment assign(const Cloud& cloud, const std::vector<Shape>& shapes, const Rules& rules);

/// Points that true regions and detections share.
struct Overlaps {
  std::vector<int> true_size;            ///< points of each true region
  std::vector<int> found_size;           ///< points of each detection
  std::vector<std::vector<int>> common;  ///< [true region][detection]

  Overlaps(std::size_t truths, std::size_t detections);
};

/// Counts from one label a point, -1 for none; other labels must be below the given counts.
Overlaps countOverlaps(const std::vector<int>& truth, std::size_t truths, const std::vector<int>& found,
                       std::size_t detections);

/// SegComp's instances in one scene.
struct Segmentation {
  std::vector<std::pair<int, int>> correct;  ///< true region, detection: they share at least T of both
  int over_segmented = 0;                    ///< true regions, not correct, that two or more detections cover
  int under_segmented = 0;                   ///< detections, not correct, that cover two or more true regions
  int missed = 0;                            ///< true regions in no instance at all
  int noise = 0;                             ///< detections in no instance at all
};

/// Over-segmentation: detections that each lie to T within a true region, and together cover T of it.
/// Under-segmentation: the same with the roles exchanged. A mutual overlap of T always makes a correct pair; further
/// detections within its true region are then part of an over-segmentation, not noise (Hoover et al., definitions 1-5).
Segmentation segment(const Overlaps& overlaps, double overlap);

/// DOD in m: mean distance between the projections of the points with this label onto two shapes (paper, Evaluation
/// metrics); 0 without such points.
double objectDistance(const Cloud& cloud, const std::vector<int>& labels, int label, const Shape& truth,
                      const Shape& found);

/// Share of the points nearer than epsilon (m) to any detection; missing points do not count.
double pointCoverage(const Assignment& assignment, const Cloud& cloud, double epsilon);

/// Mean over the detections of the share of their own points nearer than epsilon (m); without points: left out.
double shapeCoverage(const Assignment& assignment, const Cloud& cloud, const std::vector<Shape>& found, double epsilon);

}  // namespace primitect::eval
