// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Robust Gauss-Newton on geometric distances; see fitting.h.
#include <Eigen/Cholesky>
#include <cmath>

#include "core/fitting.h"
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

template <class T>
constexpr Kind kKindOf = Kind::cone;
template <>
constexpr Kind kKindOf<Plane> = Kind::plane;
template <>
constexpr Kind kKindOf<Sphere> = Kind::sphere;
template <>
constexpr Kind kKindOf<Cylinder> = Kind::cylinder;

/// Normal equations of the N parameters of a kind; the lower triangle is filled.
template <int N>
struct NormalEquations {
  Eigen::Matrix<double, N, N> hessian = Eigen::Matrix<double, N, N>::Zero();
  Eigen::Matrix<double, N, 1> right = Eigen::Matrix<double, N, 1>::Zero();

  void add(const Residual& r, double weight) {
    for (int row = 0; row < N; ++row) {
      const double weighted = weight * r.gradient[row];
      right[row] -= weighted * r.distance;
      for (int column = 0; column <= row; ++column) hessian(row, column) += weighted * r.gradient[column];
    }
  }

  Gradient solve() {
    // Damped a little: a direction that the points say nothing about stays.
    hessian.diagonal().array() += 1e-9 * hessian.trace() + 1e-12;
    Gradient step = Gradient::Zero();
    step.head<N>() = hessian.template selfadjointView<Eigen::Lower>().ldlt().solve(right);
    return step;
  }
};

template <class T>
std::optional<Shape> refineKind(T shape, const SampleSet& set, const std::vector<double>& limits, double small_step) {
  constexpr int kSteps = 10;
  constexpr int kParameters = parameterCount(kKindOf<T>);
  for (int iteration = 0; iteration < kSteps; ++iteration) {
    NormalEquations<kParameters> equations;
    const auto residual_at = residualsOf(shape);
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Residual r = residual_at(set.point(k));
      const double share = r.distance / limits[k];
      if (!(std::abs(share) < 1.0)) continue;
      // Tukey's biweight; in units of the tolerance, so that far points of a depth camera count for less.
      const double root = (1.0 - share * share) / limits[k];
      equations.add(r, root * root);
    }
    const Gradient step = equations.solve();
    shape = stepped(shape, step);
    if (!usable(shape)) return std::nullopt;
    if (step.norm() < small_step) break;
  }
  return shape;
}

}  // namespace

std::optional<Shape> refine(const Shape& start, const SampleSet& set,
                            const std::function<double(const Vec3&)>& tolerance, double small_step) {
  std::vector<double> limits(set.size());
  for (std::size_t k = 0; k < set.size(); ++k) limits[k] = tolerance(set.point(k));
  return std::visit([&](const auto& shape) { return refineKind(shape, set, limits, small_step); }, start);
}

}  // namespace primitect
