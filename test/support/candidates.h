// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Candidates as the votes of one reference would propose them, and as exact samples vote for them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
inline List<Candidate> candidatesOf(const std::vector<SurfacePoint>& points, double diameter,
                                    const Params& params = presetParams("paper")) {
  List<Candidate> candidates;
  PairVoting(params).vote(samplesOf(points), diameter, candidates);
  return candidates;
}

template <class T>
std::vector<T> shapesOf(const List<Candidate>& candidates) {
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

/// Of votes of exact points for a sphere, most of 300 references: what is left is float rounding of the radius at the
/// smallest angles.
inline void expectExact(const std::vector<Sphere>& found, const Sphere& truth) {
  ASSERT_GT(found.size(), 250u);
  for (const Sphere& sphere : found) {
    EXPECT_NEAR(sphere.radius, truth.radius, 1e-4);
    EXPECT_LT((sphere.center - truth.center).norm(), 2e-4);
  }
}

/// Medians over the cylinders of most of 400 references: between the bins.
inline void expectWithinBins(const std::vector<Cylinder>& found, const Cylinder& truth) {
  ASSERT_GT(found.size(), 300u);
  std::vector<double> radius_errors, axis_errors, place_errors;
  for (const Cylinder& cylinder : found) {
    radius_errors.push_back(std::abs(cylinder.radius - truth.radius));
    axis_errors.push_back(lineAngle(cylinder.axis, truth.axis));
    place_errors.push_back((cylinder.point - truth.point).cross(truth.axis).norm());
  }
  EXPECT_LT(median(radius_errors), 2e-4);
  EXPECT_LT(median(place_errors), 2e-4);
  EXPECT_LT(median(axis_errors), 0.05 * kDegree);
}

/// Medians over the cones of most of 500 references. The ball's weights are not exact (a sixth of 10 deg at worst);
/// signs must be right, hence acos of the signed product.
inline void expectWithinBins(const std::vector<Cone>& found, const Cone& truth) {
  ASSERT_GT(found.size(), 300u);
  std::vector<double> apex_errors, axis_errors, angle_errors;
  for (const Cone& cone : found) {
    apex_errors.push_back((cone.apex - truth.apex).norm());
    axis_errors.push_back(std::acos(std::min(1.0, cone.axis.dot(truth.axis))));
    angle_errors.push_back(std::abs(cone.half_angle - truth.half_angle));
  }
  EXPECT_LT(median(axis_errors), 1.5 * kDegree);
  EXPECT_LT(median(angle_errors), 1.5 * kDegree);
  EXPECT_LT(median(apex_errors), 0.02);
}

}  // namespace primitect::test
