// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Comparing a segmentation with the true one: SegComp (Hoover et al. 1996) and the accuracy of the kinds.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "primitect/primitives.h"

namespace primitect::eval {

/// Points that true regions and detections share.
struct Overlaps {
  std::vector<int> true_size;            ///< points of each true region
  std::vector<int> found_size;           ///< points of each detection
  std::vector<std::vector<int>> common;  ///< [true region][detection]

  Overlaps(std::size_t truths, std::size_t detections);
};

/// Counts from one label a point, -1 for none. Throws std::out_of_range for a label that is not below its count and
/// std::invalid_argument for lists of unequal length.
Overlaps countOverlaps(const std::vector<int>& truth, std::size_t truths, const std::vector<int>& found,
                       std::size_t detections);

/// SegComp's instances in one scene: indices of true regions (t) and detections (d).
struct Segmentation {
  std::vector<std::pair<int, int>> correct;  ///< (t, d): they share at least T of both
  std::vector<int> over_segmented;           ///< t, not correct, that two or more detections cover
  std::vector<int> under_segmented;          ///< d, not correct, that cover two or more true regions
  std::vector<int> missed;                   ///< t in no instance at all
  std::vector<int> noise;                    ///< d in no instance at all
};

/// Over-segmentation: detections that each lie to T within a true region, and together cover T of it.
/// Under-segmentation: the same with the roles exchanged. A mutual overlap of T always makes a correct pair; further
/// detections within its true region are then part of an over-segmentation, not noise (Hoover et al., definitions 1-5).
/// overlap: T, above 0.5 so that correct pairs are unique.
Segmentation segment(const Overlaps& overlaps, double overlap);

/// Primitive type accuracy as a count: pairs (t, d), one to one, of the best overlap (intersection over union, best
/// pairs first), both of the same kind. kinds: of the true regions and of the detections.
/// Source: the measure of Li et al., SPFN, CVPR 2019, with a greedy match.
std::vector<std::pair<int, int>> sameKindMatches(const Overlaps& overlaps, const std::vector<Kind>& true_kinds,
                                                 const std::vector<Kind>& found_kinds);

}  // namespace primitect::eval
