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
std::optional<Shape> refineKind(T shape, const SampleSet& set, const std::function<double(const Vec3&)>& tolerance) {
  constexpr int kSteps = 10;
  constexpr double kSmallStep = 1e-7;  // m or rad: below any noise
  for (int iteration = 0; iteration < kSteps; ++iteration) {
    Hessian hessian = Hessian::Zero();
    Gradient right = Gradient::Zero();
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Vec3 p = set.point(k);
      const Residual r = residual(shape, p);
      const double limit = tolerance(p);
      const double share = r.distance / limit;
      if (!(std::abs(share) < 1.0)) continue;
      // Tukey's biweight; in units of the tolerance, so that far points of a depth camera count for less.
      const double root = (1.0 - share * share) / limit;
      hessian.selfadjointView<Eigen::Lower>().rankUpdate(r.gradient, root * root);
      right -= root * root * r.distance * r.gradient;
    }
    // Damped a little, which also holds parameters that this kind does not have.
    const double damping = 1e-9 * hessian.trace() + 1e-12;
    hessian.diagonal().array() += damping;
    const Gradient step = hessian.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    shape = stepped(shape, step);
    if (!usable(shape)) return std::nullopt;
    if (step.norm() < kSmallStep) break;
  }
  return shape;
}

}  // namespace

std::optional<Shape> refine(const Shape& start, const SampleSet& set,
                            const std::function<double(const Vec3&)>& tolerance) {
  return std::visit([&](const auto& shape) { return refineKind(shape, set, tolerance); }, start);
}

}  // namespace primitect
