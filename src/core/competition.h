// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The four kinds compete for given samples.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/frame_memory.h"
#include "core/hypothesis.h"
#include "primitect/params.h"

namespace primitect {

/// What a shape may be.
struct Limits {
  const Params& params;
  double max_radius;                ///< m, besides params.max_radius
  double min_half_angle_deg = 0.0;  ///< besides params.min_half_angle_deg
  double min_distance = 0.0;        ///< m, of planes from the origin: a sensor sees none that it lies in

  /// The limit that a shape breaks, of whatever kind.
  std::optional<Refusal> brokenBy(const Shape& shape) const;
  /// It is of a kind that is wanted, too.
  bool hold(const Shape& shape) const;
};

/// How candidates are checked in this frame.
struct ProposalRules {
  NoiseModel noise;
  Limits limits;
  double widen;  ///< times the noise: how far off the shape of a candidate may be
  double reach;  ///< m, of a candidate around its reference
  std::size_t most_fitted = std::numeric_limits<std::size_t>::max();  ///< samples that a fit is made of
  std::size_t least = 0;        ///< samples that a hypothesis needs, where that is more than params.min_inliers
  bool fitted = false;          ///< the hypothesis, to most of the samples, is a good start
  bool fitted_normals = false;  ///< normals are those of many points each: the edge of a box is as round as a tube

  std::size_t needed() const { return std::max(least, static_cast<std::size_t>(limits.params.min_inliers)); }
};

/// The best of all kinds for these samples, as far as their moments promise any; false when none is within the limits
/// or better than nothing. refusals: the fits that ended beyond the limits are added.
bool bestOfKinds(const Samples& samples, const HeldGains& held, const List<std::uint32_t>& set,
                 const ProposalRules& rules, Hypothesis& hypothesis, Refusals* refusals = nullptr);

/// Who comes second for the samples of a hypothesis.
struct Rival {
  std::optional<Kind> kind;  ///< of the best other kind, if its lead is small
  double lead = 1.0;         ///< score of the hypothesis over it, per sample; outside of depth frames not over kinds
                             ///< whose moments agree much worse with the samples
};
Rival bestRival(const Samples& samples, const HeldGains& held, const List<std::uint32_t>& set,
                const ProposalRules& rules, const Hypothesis& hypothesis);

}  // namespace primitect
