// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Joint voting (paper, sec. II-C): each reference collects the votes of its pairs and proposes its strongest shape.
#pragma once

#include <optional>

#include "core/accumulators.h"
#include "core/candidate.h"
#include "core/frame_memory.h"
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

  /// How many references there are at most, instead of the parameter's number.
  void setReferences(std::size_t count) { most_references_ = count; }

  /// Whether a reference votes with all samples within reach, or with verify only with the nearest where they are many.
  void pairWithAll(bool all) { all_pairs_ = all; }

  /// Bins of radii are so many times as wide as params.radius_bin says, and reach so many times as far.
  void stretchRadii(double times) { radius_stretch_ = times; }

  /// Gets ready for references among these samples, which must stay until the last one has voted. d_s in m.
  void begin(const Samples& samples, double scene_diameter);

  /// How many references there are: no more than samples, with verify no more than a third of them.
  std::size_t references() const { return references_; }

  /// Sample that is the k-th reference; they are spread evenly over the samples.
  std::uint32_t reference(std::size_t k) const {
    return static_cast<std::uint32_t>(k * samples_->size() / references_);
  }

  /// Adds the strongest shape that the pairs of this sample vote for, if there is one.
  void voteAt(std::uint32_t sample, List<Candidate>& candidates);

  /// begin(), and all references: at most one candidate for each.
  void vote(const Samples& samples, double scene_diameter, List<Candidate>& candidates);

 private:
  std::optional<Candidate> strongest(const kernels::Reference& reference) const;
  void proposeCurved(const kernels::Reference& reference, Side side, std::optional<Candidate>& best) const;
  /// Makes it the best one if the peak has more votes than min_votes and what was best.
  void propose(const Peak& peak, Candidate candidate, std::optional<Candidate>& best) const;

  /// What a peak must have more votes than.
  double toBeat(const std::optional<Candidate>& best) const { return best ? best->votes : params_.min_votes; }

  Params params_;
  std::size_t most_references_;
  bool all_pairs_ = false;
  double radius_stretch_ = 1.0;
  const kernels::Kernels& kernels_;
  const Samples* samples_ = nullptr;
  std::size_t references_ = 0;
  kernels::VotingRules rules_ = {};
  SampleBoxes boxes_;
  Accumulators accumulators_;
};

}  // namespace primitect
