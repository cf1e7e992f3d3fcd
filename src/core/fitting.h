// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes of a wanted kind through given points: a start from moments of points and normals, then robust least squares.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/samples.h"
#include "primitect/primitives.h"

namespace primitect {

/// Some of the samples, by index.
struct SampleSet {
  const Samples& samples;
  const std::vector<std::uint32_t>& indices;
  double side = 1.0;  ///< -1: seen from inside, the normals are turned round to point out of the shape

  std::size_t size() const { return indices.size(); }
  Vec3 point(std::size_t k) const { return samples.point(indices[k]); }
  Vec3 normal(std::size_t k) const { return side * samples.normal(indices[k]); }
};

/// Shape of this kind from moments of points p and normals n, without iteration:
///   plane     the least spread of p
///   sphere    p = c + R n in the mean
///   cylinder  axis: the least of E[n n'], then the sphere's equation across it
///   cone      axis: the least spread of n; apex: where the tangent planes meet, sum(n n') c = sum(n n' p)
/// Nothing when the points do not determine it.
std::optional<Shape> fitFromMoments(Kind kind, const SampleSet& set);

/// The shape with least sum of Tukey's biweight of geometric distances, by Gauss-Newton from the given start; points
/// beyond tolerance(p) (m) have no influence. It ends when a step (m, rad) is small. Nothing when it does not end in a
/// finite shape.
std::optional<Shape> refine(const Shape& start, const SampleSet& set,
                            const std::function<double(const Vec3&)>& tolerance, double small_step = 1e-7);

}  // namespace primitect
