// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Robust Gauss-Newton on geometric distances; see fitting.h.
#include <algorithm>
#include <cmath>
#include <type_traits>

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

template <class T>
constexpr int kParameters = 0;
template <>
constexpr int kParameters<Plane> = parameterCount(Kind::plane);
template <>
constexpr int kParameters<Sphere> = parameterCount(Kind::sphere);
template <>
constexpr int kParameters<Cylinder> = parameterCount(Kind::cylinder);
template <>
constexpr int kParameters<Cone> = parameterCount(Kind::cone);

template <class T>
constexpr bool kHasAxis = std::is_same_v<T, Cylinder> || std::is_same_v<T, Cone>;

/// L D L' without pivots, which a matrix of squares does not need. Eigen's, with pivots and of a size that is known
/// only when it runs, takes six times as many instructions: 2 % of a frame.
template <int count>
Gradient solve(const kernels::NormalEquations& equations) {
  double trace = 0.0;
  for (int k = 0; k < count; ++k) trace += equations.hessian[k][k];
  // Damped a little: a direction that the points say nothing about stays.
  const double damping = 1e-9 * trace + 1e-12;
  double lower[count][count], scaled[count][count], inverse[count];  // L, L D, 1 / D
  Gradient step = Gradient::Zero();
  for (int row = 0; row < count; ++row) {
    double pivot = equations.hessian[row][row] + damping, right = equations.right[row];
    for (int column = 0; column < row; ++column) {
      double rest = equations.hessian[row][column];
      for (int k = 0; k < column; ++k) rest -= scaled[row][k] * lower[column][k];
      scaled[row][column] = rest;
      lower[row][column] = rest * inverse[column];
      pivot -= rest * lower[row][column];
      right -= lower[row][column] * step[column];
    }
    // No less than the damping, but for rounding.
    inverse[row] = pivot > 0.5 * damping ? 1.0 / pivot : 0.0;
    step[row] = right;
  }
  for (int row = count - 1; row >= 0; --row) {
    step[row] *= inverse[row];
    for (int k = row + 1; k < count; ++k) step[row] -= lower[k][row] * step[k];
  }
  return step;
}

/// As if points said nothing about where the axis of a cylinder or a cone points: it stays.
void holdAxis(kernels::NormalEquations& equations) {
  constexpr int kTurns[] = {2, 3};  // of both (steppedBeside())
  for (const int turn : kTurns) {
    for (int k = 0; k < kMostParameters; ++k) equations.hessian[turn][k] = equations.hessian[k][turn] = 0.0;
    equations.right[turn] = 0.0;
  }
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

/// A step ended at the sharpest cone that there is.
bool isSharpest(const Cone& cone) { return cone.half_angle == kLeastHalfAngle; }
template <class T>
bool isSharpest(const T&) {
  return false;
}

/// pointsFor(shape): what a step from this shape is made of.
template <class T, class PointsFor>
std::optional<Shape> refineKind(T shape, const FitPoints& points, const RefineRules& rules,
                                const PointsFor& pointsFor) {
  constexpr int kEnoughSharpest = 3;
  kernels::NormalEquations equations = {};
  int sharpest = 0;  // steps in a row
  for (int iteration = 0; iteration < rules.most_steps; ++iteration) {
    const float scale = iteration < rules.wide_steps ? static_cast<float>(1.0 / rules.widen) : 1.0f;
    kernels::loops().normalEquations(flattenedBeside(points.middle(), shape, points.origin()), flattened(turnOf(shape)),
                                     pointsFor(shape), scale, equations);
    if (kHasAxis<T> && rules.hold_axis) holdAxis(equations);
    const Gradient step = lengthOf(equations) * solve<kParameters<T>>(equations);
    shape = steppedBeside(points.middle(), shape, step);
    if (!usable(shape)) return std::nullopt;
    if (iteration < rules.wide_steps) continue;
    if (isSmall(step, equations, rules.small_step)) break;
    // A cylinder is as good: steps that would turn such a cone further are not worth their time.
    sharpest = isSharpest(shape) ? sharpest + 1 : 0;
    if (sharpest == kEnoughSharpest) break;
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
