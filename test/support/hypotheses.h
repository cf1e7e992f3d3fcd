// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Samples with a known noise, and what shapes make of them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/fit_points.h"
#include "core/hypothesis.h"
#include "core/noise.h"
#include "core/proposal.h"
#include "core/sample_graph.h"
#include "core/selection.h"
#include "test/support/noisy_points.h"

namespace primitect::test {

/// The noise of all points alike; normals off by half a radian are hardly noise.
const NoiseModel kNoiseModel = {kNoise, 0.0, 0.5};

inline Samples samplesWith(const NoiseModel& noise, const std::vector<SurfacePoint>& points) {
  Samples samples = samplesOf(points);
  applyNoise(noise, samples);
  return samples;
}

/// Samples measured with kNoise and normals turned by noise about two axes (rad).
inline Samples noisySamples(const std::vector<SurfacePoint>& points, double turn, Random& random) {
  return samplesWith(kNoiseModel, measured(points, kNoise, turn, random));
}

/// The shape against these samples, of which nothing is explained yet.
inline Hypothesis hypothesisOf(const Shape& shape, const Samples& samples, bool concave = false) {
  Hypothesis hypothesis;
  hypothesis.shape = shape;
  hypothesis.concave = concave;
  evaluate(samples, HeldGains(samples.size(), 0.0f), 1.0, hypothesis);
  return hypothesis;
}

inline std::size_t inlierCount(const Hypothesis& hypothesis) {
  List<std::uint32_t> inliers;
  inliersOf(hypothesis, inliers);
  return inliers.size();
}

/// A proposal for this shape from the sample of that index.
inline Candidate proposalAt(const Shape& shape, const Samples& samples, std::uint32_t reference, bool concave = false) {
  Candidate candidate;
  candidate.shape = shape;
  candidate.concave = concave;
  candidate.point = samples.point(reference);
  candidate.normal = samples.normal(reference);
  candidate.votes = 100.0;
  candidate.sample = reference;
  return candidate;
}

/// All of them as the points of a fit.
inline FitPoints fitPointsOf(const Samples& samples) {
  FitPoints points;
  const List<std::uint32_t> all = allOf(samples);
  points.gather({samples, all});
  return points;
}

}  // namespace primitect::test
