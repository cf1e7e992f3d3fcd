// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes of a wanted kind through given points: a start from moments of points and normals, then robust least squares.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

#include "core/fit_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Means over points p, relative to their origin, and normals n.
struct Moments {
  std::size_t count = 0;
  Vec3 origin = Vec3::Zero();  ///< near the mean point
  Vec3 mean_point = Vec3::Zero();
  Vec3 mean_normal = Vec3::Zero();
  Eigen::Matrix3d points = Eigen::Matrix3d::Zero();   ///< E[p p'], p from the mean point
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();  ///< E[n n']
  Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero();    ///< E[p n'], p from the mean point
  Vec3 tangent = Vec3::Zero();                        ///< E[n n' p], p from the mean point
};

Moments momentsOf(const FitPoints& points);

/// The same surface seen from inside: the normals are turned round to point out of the shape.
Moments flipped(Moments moments);

/// Shape of this kind from moments of points p and normals n, without iteration:
///   plane     the least spread of p
///   sphere    p = c + R n in the mean
///   cylinder  axis: the least of E[n n'], then the sphere's equation across it
///   cone      axis: the least spread of n; apex: where the tangent planes meet, sum(n n') c = sum(n n' p)
/// Nothing when the points do not determine it.
std::optional<Shape> fitFromMoments(Kind kind, const Moments& moments);

/// How long the search goes on.
struct RefineRules {
  double widen = 1.0;        ///< times the tolerance in the first steps, so that a poor start is not left where it is
  int wide_steps = 0;        ///< how many these are
  int most_steps = 10;       ///< these included
  double small_step = 1e-4;  ///< after a step that moves the surface at the points by less there is no other; root of
                             ///< the mean square of what it moves by, in shares of the tolerance
  bool hold_axis = false;    ///< of a cylinder or a cone: as it is at the start
};

/// The shape with least sum of Tukey's biweight of geometric distances, by Gauss-Newton from the given start; points
/// beyond their tolerance have no influence. Nothing when it does not end in a finite shape.
std::optional<Shape> refine(const Shape& start, const FitPoints& points, const RefineRules& rules = {});

/// The same for points of a depth camera at the origin whose depths alone are wrong (along_rays.h).
std::optional<Shape> refineAlongRays(const Shape& start, const FitPoints& points, const RefineRules& rules = {});

/// The same for samples with another tolerance (m).
std::optional<Shape> refine(const Shape& start, const SampleSet& set,
                            const std::function<double(const Vec3&)>& tolerance, const RefineRules& rules = {});

/// So many points are enough to compare shapes that differ much: takes an eighth of the time that 8192 take.
constexpr std::size_t kEnoughToCompare = 1024;

/// How well a shape agrees with the points: sum of 1 - (distance / tolerance)^2 over those within their tolerance. Of
/// more than `most` points only `most` to twice as many are asked.
double agreement(const Shape& shape, const FitPoints& points,
                 std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace primitect
