// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which samples belong to which shape: every sample is explained at most once.
#pragma once

#include <cstdint>
#include <optional>

#include "core/candidate.h"
#include "core/frame_memory.h"
#include "core/samples.h"
#include "core/tolerance.h"
#include "primitect/evidence.h"
#include "primitect/params.h"

namespace primitect {

/// A candidate that keeps enough samples for itself.
struct Segment {
  Candidate candidate;
  List<std::uint32_t> inliers;  ///< indices of samples
  // Of verified ones:
  std::uint32_t hypothesis = 0;  ///< its index among the hypotheses of the frame
  Evidence evidence;
  std::optional<Kind> rival;  ///< the other kind that would explain the samples nearly as well
  double confidence = kUnknown;
};

/// Takes the candidates in their order; each keeps the samples within the tolerance that no earlier one explains, and
/// is added to the segments when these are at least params.min_inliers.
void selectSegments(const Samples& samples, const List<Candidate>& candidates, const Params& params,
                    const Tolerance& tolerance, List<Segment>& segments);

/// Gives every sample to the nearest of the segments within the same tolerances, or to none; segments that keep fewer
/// than params.min_inliers go.
void assignSamples(const Samples& samples, const Params& params, const Tolerance& tolerance, List<Segment>& segments);

/// Of spheres and cylinders (m).
std::optional<double> radiusOf(const Shape& shape);

/// Which limit of params the shape's radius or half angle breaks, if any.
std::optional<Refusal> brokenLimit(const Shape& shape, const Params& params);
bool withinLimits(const Shape& shape, const Params& params);

/// A cone with a smaller half angle than this.
bool isSharper(const Shape& shape, double half_angle_deg);

/// The least half angle (deg) of candidates from votes, and of what samples of lists are taken for: these are too few
/// to tell a cone sharper than 8 deg from a cylinder. As a cylinder it is found, and the points of the cloud make a
/// cone of it (refineOnPoints()). That of params where nothing is verified, or cylinders are not wanted.
double sharpestOfSamples(const Params& params);

/// The same params with that.
Params limitsForSamples(Params params);

}  // namespace primitect
