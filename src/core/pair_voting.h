// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Joint voting (paper, sec. II-C): each reference collects the votes of its pairs and proposes its strongest shape.
#pragma once

#include <optional>
#include <vector>

#include "core/accumulators.h"
#include "core/candidate.h"
#include "core/sample_boxes.h"
#include "core/samples.h"
#include "primitect/params.h"

namespace primitect {

/// Conditions and switches for a scene of this diameter d_s (m).
kernels::VotingRules votingRules(const Params& params, double scene_diameter);

/// The reference's local frame: the rows of R_x, which turns its normal to the positive x axis.
kernels::Reference referenceAt(const Samples& samples, std::size_t i);

/// Shapes from voting parameters and the reference (point, outward unit normal), lengths in m, angles in rad.
Sphere sphereFromVotes(const Vec3& point, const Vec3& normal, double radius);
Cylinder cylinderFromVotes(const Vec3& point, const Vec3& normal, const Vec3& axis, double radius);
/// Apex, signed axis and half angle of the paper's eq. 11 to 13. Nothing when the axis is parallel to the tangent plane
/// (a cylinder) or to the normal (a plane).
std::optional<Cone> coneFromVotes(const Vec3& point, const Vec3& normal, const Vec3& axis, double axis_distance);

/// Joint voting with accumulators that are reused from reference to reference and from frame to frame.
class PairVoting {
 public:
  /// Throws std::invalid_argument as kernels::chosenKernels().
  explicit PairVoting(const Params& params);

  /// How many references vote() takes at most, instead of the parameter's number.
  void setReferences(std::size_t count) { references_ = count; }

  /// At most one candidate for each reference; the references are spread evenly over the samples. d_s in m.
  void vote(const Samples& samples, double scene_diameter, std::vector<Candidate>& candidates);

 private:
  std::optional<Candidate> strongest(const kernels::Reference& reference) const;
  void proposeCurved(const kernels::Reference& reference, Side side, std::optional<Candidate>& best) const;
  /// Makes it the best one if the peak has more votes than min_votes and what was best.
  void propose(const Peak& peak, Candidate candidate, std::optional<Candidate>& best) const;

  /// What a peak must have more votes than.
  double toBeat(const std::optional<Candidate>& best) const { return best ? best->votes : params_.min_votes; }

  Params params_;
  std::size_t references_;
  const kernels::Kernels& kernels_;
  SampleBoxes boxes_;
  Accumulators accumulators_;
};

}  // namespace primitect
