// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The loop around PCL's SACSegmentationFromNormals that its users write.
#pragma once

#include "eval/methods.h"

namespace primitect::eval {

/// "pcl-sac": fit plane, sphere, cylinder and cone to the points that are left (RANSAC), take the one with most
/// inliers, remove these, go on.
///
/// PCL has no such loop itself; what its tutorials leave open is chosen thus:
/// - 4096 random points (seed: the recipe's), as every step goes over all points and users thin their clouds first:
///   with all 160,801 points of a scene of the paper it takes minutes.
/// - distance threshold 1 % of the diagonal of the bounding box, the default of Efficient RANSAC;
///   normal weight 0.1 and coefficients optimized as in PCL's cylinder tutorial; 1000 iterations.
/// - radii up to a quarter of the diagonal, cones with half angles of 5 to 60 degrees: without limits, vast cylinders
///   and flat cones take the place of the planes. A more general kind must win by 5 %, for the same reason.
/// - it ends when the best has less than 1 % of the points (Efficient RANSAC's default), at the latest after 40 rounds.
/// The time contains neither thinning nor conversion.
Method makePclSac();

}  // namespace primitect::eval
