// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The second-order bias of the normal equations, from two points either side of the surface; see bias.h.
#include "core/bias.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/covariance.h"
#include "core/evenly.h"
#include "core/residuals.h"

namespace primitect {
namespace {

/// Sums over the points that took part in the fit.
struct Sums {
  Hessian information = Hessian::Zero();  ///< of g g' / sigma^2
  Gradient bias = Gradient::Zero();       ///< of E[r g] / sigma^2
  double measured = 0.0;                  ///< of (r / sigma)^2
  double expected = 0.0;                  ///< the same, as sigma has it
};

/// E[r g] of noise along an offset of one standard deviation (m) that is symmetric around the surface.
template <class T>
Gradient meanProduct(const T& shape, const Vec3& on_surface, const Vec3& offset) {
  const Residual above = residual(shape, on_surface + offset);
  const Residual below = residual(shape, on_surface - offset);
  return 0.5 * (above.distance * above.gradient + below.distance * below.gradient);
}

template <class T>
void add(const T& shape, const Vec3& p, double sigma, NoiseDirection direction, Sums& sums) {
  const Residual r = residual(shape, p);
  if (!(std::abs(r.distance) < kFitDeviations * sigma)) return;
  const Vec3 normal = normalAt(shape, p);
  const Vec3 on_surface = p - r.distance * normal;
  const double weight = 1.0 / (sigma * sigma);
  sums.information += weight * r.gradient * r.gradient.transpose();
  sums.measured += weight * r.distance * r.distance;
  if (direction == NoiseDirection::along_ray) {
    const Vec3 ray = p / p.z();
    sums.bias += weight * meanProduct(shape, on_surface, sigma * ray);
    sums.expected += ray.dot(normal) * ray.dot(normal);
    return;
  }
  for (int axis = 0; axis < 3; ++axis) sums.bias += weight * meanProduct(shape, on_surface, sigma * Vec3::Unit(axis));
  sums.expected += 1.0;
}

bool usable(const Plane& plane) { return plane.point.allFinite() && plane.normal.allFinite(); }
bool usable(const Sphere& sphere) { return sphere.center.allFinite() && sphere.radius > 0.0; }
bool usable(const Cylinder& cylinder) { return cylinder.point.allFinite() && cylinder.radius > 0.0; }
bool usable(const Cone& cone) { return cone.apex.allFinite() && 0.0 < cone.half_angle && cone.half_angle < M_PI / 2.0; }

template <class T>
T corrected(const T& shape, Sums sums) {
  const double noise_sq = std::clamp(sums.measured / sums.expected, 0.0, 1.5);
  sums.information.diagonal().array() += 1e-9 * sums.information.trace() + 1e-12;
  const Gradient step = noise_sq * sums.information.ldlt().solve(sums.bias);
  const T result = stepped(shape, step);
  return step.allFinite() && usable(result) ? result : shape;
}

}  // namespace

Shape withoutBias(const Shape& shape, const std::vector<Vec3>& inliers, const std::function<double(const Vec3&)>& sigma,
                  NoiseDirection direction) {
  return std::visit(
      [&](const auto& s) -> Shape {
        Sums sums;
        // The correction is a mean: with more points it would be the same.
        constexpr std::size_t kMostPoints = 1021;
        forEvenly(inliers, kMostPoints, [&](const Vec3& p) { add(s, p, sigma(p), direction, sums); });
        return corrected(s, sums);
      },
      shape);
}

}  // namespace primitect
