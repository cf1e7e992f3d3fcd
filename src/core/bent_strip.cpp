// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A parabola across the strip; see bent_strip.h.
#include "core/bent_strip.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/ramp.h"
#include "core/strip.h"

namespace primitect {

Bend bendAcross(const Plane& plane, const Extent& extent, const SeenPoints& points) {
  const Vec3 along = extent.rotation.col(0), across = extent.rotation.col(1);
  const double width = extent.size.y();
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();
  double squares = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 point = points.point(k), from = (point - extent.origin) / width;
    const double u = from.dot(along), v = from.dot(across), height = distance(plane, point) / width;
    const Eigen::Vector4d terms(1.0, u, v, v * v);
    products.noalias() += terms * terms.transpose();
    sums += height * terms;
    squares += height * height;
  }
  // Points in two lines do not tell, nor do a few: of flat strips of 5 points 10 % would seem bent, of 10 one in a
  // thousand. Exact ones have no noise to measure.
  constexpr double kFewestFree = 10.0, kLeastSpread = 1e-3, kMostSpread = 1.0, kExact = 1e-12;
  const double count = static_cast<double>(points.size()), free = count - 4.0;
  const Eigen::LDLT<Eigen::Matrix4d> solver(products);
  // What of the squares across nothing else explains: of points all over a strip 1 / 180 for each.
  const double spread = 1.0 / solver.solve(Eigen::Vector4d::UnitW()).w();
  if (!(free >= kFewestFree && spread > kLeastSpread * count && spread < kMostSpread * count)) return {0.0, 0.0};
  const Eigen::Vector4d fit = solver.solve(sums);
  const double variance = std::max(0.0, squares - fit.dot(sums)) / free / spread;
  return {-2.0 * fit.w(), -fit.w() / std::max(std::sqrt(variance), kExact)};
}

double trustInFlat(const Plane& plane, const Extent& extent, const SeenPoints& points) {
  // Measured on 60 simulated tables: of 446 planes longer than twice their width none turns by more than 0.37, 99 % by
  // less than 0.22; strips of tubes of 12 and 15 mm radius 1 m away by 0.65 to 1.5, 10 standard deviations and more.
  if (points.empty() || !isStrip(extent)) return 1.0;
  const Bend bend = bendAcross(plane, extent, points);
  return 1.0 - ramp(0.4, 0.6, std::abs(bend.turn)) * ramp(4.0, 8.0, std::abs(bend.deviations));
}

}  // namespace primitect
