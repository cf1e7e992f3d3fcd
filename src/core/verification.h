// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Checking candidates on the samples: the kinds compete for the points of a candidate, and the winner is refined on
// them.
#pragma once

#include <vector>

#include "core/candidate.h"
#include "core/samples.h"
#include "core/segmentation.h"
#include "core/tolerance.h"
#include "primitect/params.h"

namespace primitect {

/// Noise of clouds that no depth camera's model fits: three standard deviations (m) of the distances of samples to the
/// shapes that explain the strongest candidates best; the lower quartile of these, at most `loose`.
double estimateNoiseTolerance(const Samples& samples, const std::vector<Candidate>& candidates, const Tolerance& loose);

/// Adds segments for candidates that stand the test. In the order of votes: the samples within `loose` that nothing
/// explains yet are fitted with all four kinds (moments, then robust least squares); the kind with the best score sum(1
/// - (distance / tolerance)^2) less a price for its parameters wins, if it is within the limits of params and of
/// max_radius (m), its normals turn enough for a curved shape, and it keeps params.min_inliers samples.
void verifyCandidates(const Samples& samples, const std::vector<Candidate>& candidates, const Params& params,
                      const Tolerance& loose, const Tolerance& tight, double max_radius,
                      std::vector<Segment>& segments);

/// Fits every segment's shape to its inliers once more, where that succeeds within the same limits.
void refineSegments(const Samples& samples, const Params& params, const Tolerance& tight, double max_radius,
                    std::vector<Segment>& segments);

}  // namespace primitect
