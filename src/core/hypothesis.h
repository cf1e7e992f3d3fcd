// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A shape with what it explains: the gain of every sample near it.
#pragma once

#include <cstdint>
#include <limits>

#include "core/frame_memory.h"
#include "core/noise.h"
#include "core/samples.h"
#include "primitect/primitives.h"

namespace primitect {

/// What a shape makes of one sample near it: 1 for a sample on it whose normal is its own, falling with the square of
/// distance and angle; above 0 for an inlier; below for one that is near, and alike, but does not fit.
struct Support {
  std::uint32_t sample;
  float gain;
};

struct Hypothesis {
  static constexpr double kAnywhere = std::numeric_limits<double>::infinity();

  Shape shape;
  bool concave = false;
  double votes = 0.0;          ///< of the candidate that proposed it
  Vec3 middle = Vec3::Zero();  ///< of the samples that it was fitted to
  double reach = kAnywhere;    ///< m, how far from there these are
  List<Support> support;       ///< in the order of the samples
  double score = 0.0;          ///< sum of the gains less the price of the shape's parameters
  double gain_sum = 0.0;       ///< of the gains above 0
  std::size_t inliers = 0;     ///< samples with a gain above 0
  List<std::uint64_t> blocks;  ///< bits: in which blocks of samples there is support
  List<std::uint64_t> on;      ///< bits: which samples are inliers
  List<std::uint64_t> near;    ///< bits: which samples there is support at, and maybe more
};

/// False when they have no sample in common.
bool mayOverlap(const Hypothesis& a, const Hypothesis& b);

/// False when the other one explains no sample near the hypothesis, whose worth is then the same with and without it.
/// In place of mayOverlap() it saves 4 % of a recorded frame's instructions where planes are many.
bool concerns(const Hypothesis& other, const Hypothesis& hypothesis);

/// How many samples are inliers of both.
std::size_t commonInliers(const Hypothesis& a, const Hypothesis& b);

/// The best gain that any hypothesis has at each sample; nothing yet: 0.
using HeldGains = List<float>;

/// A sample with this gain needs no better explanation.
using kernels::kWellExplained;

/// Fills score, gain_sum and inliers from the shape. Samples that others explain well do not speak against it, nor does
/// a block of them beyond its reach that would: nothing there is the shape's; nor does, against a plane
/// that is large in the first draw (plane_parts.h), a block of later ones: these left out what it explains. widen:
/// times the noise, for a shape that is not fitted yet.
void score(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis);

/// Of the samples of a block. Made without values: they are written anyway, and zeros before took .4 % of a frame's
/// instructions.
struct BlockGains {
  float of[SampleBlocks::kSize];

  BlockGains() {}
};

/// The gains of the samples in the blocks near a shape.
struct NearGains {
  List<SampleBlock> blocks;
  List<BlockGains> gains;  ///< of each block, and maybe of one more
};

/// The same, and keeps the gains, so that the support of the best of several shapes need not be evaluated once more.
void score(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis, NearGains& near);

/// Fills support and blocks of the hypothesis from its gains.
void fillSupport(const Samples& samples, const NearGains& near, Hypothesis& hypothesis);

/// Fills support and blocks, too.
void evaluate(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis);

/// Indices of the samples within reach (m) of a point that the shape of the hypothesis has a gain above 0 at.
void inliersAround(const Vec3& point, double reach, const Samples& samples, const HeldGains& held, double widen,
                   const Hypothesis& hypothesis, List<std::uint32_t>& inliers);

/// Samples that nobody holds, in rising order.
List<std::uint32_t> notHeld(const HeldGains& held);

/// Takes the gains of the hypothesis into those held.
void hold(const Hypothesis& hypothesis, HeldGains& held);

/// Takes these samples (rising indices) from the support; the score stays.
void withhold(const List<std::uint32_t>& samples, Hypothesis& hypothesis);

/// Nothing is explained any more.
void silence(Hypothesis& hypothesis);

/// Score that a shape with so many inliers pays for its parameters: a plane has three, a cone six.
double priceOf(Kind kind, double inliers);

/// What a hypothesis makes of these samples (rising indices) alone: its gains there less its price.
double worthAt(const List<std::uint32_t>& samples, const Hypothesis& hypothesis);

/// Samples with a gain above 0.
void inliersOf(const Hypothesis& hypothesis, List<std::uint32_t>& inliers);

}  // namespace primitect
