// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Spread in the tangent plane; see ball_band.h.
#include "core/ball_band.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace primitect {

BallBand bandOn(const Sphere& ball, const Vec3& mean, const Eigen::Matrix3d& scatter) {
  const Vec3 out = (mean - ball.center).normalized(), one = out.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << one, out.cross(one);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(tangents.transpose() * scatter * tangents, Eigen::EigenvaluesOnly);
  const double narrow = std::max(0.0, solver.eigenvalues()[0]), wide = solver.eigenvalues()[1];
  // Of a band of even width w the variance across is w^2 / 12, and the surface rises by w^2 / 8 r.
  return {std::sqrt(wide / narrow), 1.5 * narrow / ball.radius};
}

}  // namespace primitect
