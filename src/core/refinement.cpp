// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Robust Gauss-Newton on geometric distances; see fitting.h.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/along_rays.h"
#include "core/fitting.h"
#include "core/flat.h"
#include "core/residuals.h"

namespace primitect {
namespace {

bool usable(const Plane& plane) { return plane.point.allFinite() && plane.normal.allFinite(); }
bool usable(const Sphere& sphere) { return sphere.center.allFinite() && 0.0 < sphere.radius && sphere.radius < 1e6; }
bool usable(const Cylinder& cylinder) {
  return cylinder.point.allFinite() && cylinder.axis.allFinite() && 0.0 < cylinder.radius && cylinder.radius < 1e6;
}
bool usable(const Cone& cone) {
  return cone.apex.allFinite() && cone.axis.allFinite() && 0.0 < cone.half_angle && cone.half_angle < M_PI / 2.0;
}

/// Directions across what the shape points along; a sphere has none.
Turn turnOf(const Plane& plane) { return Turn(plane.normal); }
Turn turnOf(const Sphere&) { return Turn(Vec3::UnitZ()); }
Turn turnOf(const Cylinder& cylinder) { return Turn(cylinder.axis); }
Turn turnOf(const Cone& cone) { return Turn(cone.axis); }

/// Of one type for all kinds: the decomposition takes seconds to compile.
Gradient solve(int parameters, const kernels::NormalEquations& equations) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostParameters, kMostParameters>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostParameters, 1>;
  Matrix hessian = Matrix::Zero(parameters, parameters);
  Column right(parameters);
  for (int row = 0; row < parameters; ++row) {
    for (int column = 0; column <= row; ++column) hessian(row, column) = equations.hessian[row][column];
    right[row] = equations.right[row];
  }
  // Damped a little: a direction that the points say nothing about stays.
  hessian.diagonal().array() += 1e-9 * hessian.trace() + 1e-12;
  Gradient step = Gradient::Zero();
  step.head(parameters) = Eigen::LDLT<Matrix>(hessian).solve(right);
  return step;
}

/// With fixed weights a step is too short: points lose weight as the surface goes away from them. This times, it is
/// Newton's as if distances were spread alike along all gradients; below 2 the sum of what is minimised falls all the
/// same.
double lengthOf(const kernels::NormalEquations& equations) {
  constexpr double kMost = 1.9;
  return equations.weight < kMost * equations.curvature ? std::max(1.0, equations.weight / equations.curvature) : kMost;
}

/// Root mean square of what the step moves the surface by at the points is less than this share of the tolerance.
bool isSmall(const Gradient& step, const kernels::NormalEquations& equations, double share) {
  const Eigen::Map<const Gradient> right(equations.right);
  return step.dot(right) <= share * share * equations.weight;
}

/// pointsFor(shape): what a step from this shape is made of.
template <class T, class PointsFor>
std::optional<Shape> refineKind(T shape, const FitPoints& points, const RefineRules& rules,
                                const PointsFor& pointsFor) {
  const int parameters = parameterCount(kindOf(shape));
  kernels::NormalEquations equations = {};
  for (int iteration = 0; iteration < rules.most_steps; ++iteration) {
    const float scale = iteration < rules.wide_steps ? static_cast<float>(1.0 / rules.widen) : 1.0f;
    kernels::loops().normalEquations(flattenedBeside(points.middle(), shape, points.origin()), flattened(turnOf(shape)),
                                     pointsFor(shape), scale, equations);
    const Gradient step = lengthOf(equations) * solve(parameters, equations);
    shape = steppedBeside(points.middle(), shape, step);
    if (!usable(shape)) return std::nullopt;
    if (iteration >= rules.wide_steps && isSmall(step, equations, rules.small_step)) break;
  }
  return shape;
}

}  // namespace

std::optional<Shape> refine(const Shape& start, const FitPoints& points, const RefineRules& rules) {
  const auto as_they_are = [&points](const auto&) { return points.view(); };
  return std::visit([&](const auto& shape) { return refineKind(shape, points, rules, as_they_are); }, start);
}

std::optional<Shape> refineAlongRays(const Shape& start, const FitPoints& points, const RefineRules& rules) {
  AlongRays along_rays(points);
  const auto moved = [&along_rays](const auto& shape) { return along_rays.pointsFor(shape); };
  return std::visit([&](const auto& shape) { return refineKind(shape, points, rules, moved); }, start);
}

std::optional<Shape> refine(const Shape& start, const SampleSet& set,
                            const std::function<double(const Vec3&)>& tolerance, const RefineRules& rules) {
  FitPoints points;
  points.gather(set, tolerance);
  return refine(start, points, rules);
}

double agreement(const Shape& shape, const FitPoints& points, std::size_t most) {
  const kernels::FitPoints view = points.view();
  const std::size_t every = std::max<std::size_t>(1, view.count / most);
  return kernels::loops().agreement(flattened(shape, points.origin()), view, every);
}

}  // namespace primitect
