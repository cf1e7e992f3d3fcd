// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Candidates as the votes of one reference would propose them, and as exact samples vote for them.
#pragma once

#include <algorithm>
#include <vector>

#include "core/candidate.h"
#include "core/pair_voting.h"
#include "primitect/params.h"
#include "test/support/exact_shapes.h"

namespace primitect::test {

inline Candidate candidate(const Shape& shape, const SurfacePoint& reference, double votes) {
  Candidate proposed;
  proposed.shape = shape;
  proposed.point = reference.point;
  proposed.normal = reference.normal;
  proposed.votes = votes;
  return proposed;
}

/// The strongest candidate of every reference; d_s in m.
inline std::vector<Candidate> candidatesOf(const std::vector<SurfacePoint>& points, double diameter,
                                           const Params& params = presetParams("paper")) {
  std::vector<Candidate> candidates;
  PairVoting(params).vote(samplesOf(points), diameter, candidates);
  return candidates;
}

template <class T>
std::vector<T> shapesOf(const std::vector<Candidate>& candidates) {
  std::vector<T> shapes;
  for (const Candidate& candidate : candidates) {
    if (const T* shape = std::get_if<T>(&candidate.shape)) shapes.push_back(*shape);
  }
  return shapes;
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

}  // namespace primitect::test
