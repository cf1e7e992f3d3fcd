// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Turn of the normals and bulge of the points; see curvature.h.
#include "core/curvature.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace primitect {

Curvature curvatureOf(const Moments& moments, double sigma) {
  if (moments.count == 0) return {0.0, 0.0};
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.points, Eigen::EigenvaluesOnly);
  return {1.0 - moments.mean_normal.norm(), std::sqrt(std::max(0.0, solver.eigenvalues()[0])) / sigma};
}

bool curvesEnough(Kind kind, const Curvature& curvature, const NoiseModel& noise) {
  constexpr double kLeastTurn = 0.012;  // an arc of 31 deg
  // Arcs of 40 deg: what normals show of a can of which a bit more than half is hidden. Of balls 49: the lid of a tin,
  // a shallow dome, is none.
  constexpr double kLeastTurnOfDepth = 0.02, kLeastTurnOfBall = 0.03;
  // With 1.2 fewer of what is found on 80 tables (seeds 2300, 2400) is right.
  constexpr double kLeastBulgeOfDepth = 1.3, kLeastBulgeOfBall = 1.5;
  // Waves that turn so far (63 deg) would have to be higher than they are; a thin tube does not rise farther.
  constexpr double kLargeTurn = 0.05, kLeastBulgeOfLargeTurn = 1.0;
  // Nor do waves rise so far: what is close up and so large that only an arc of 22 deg is in view is no plane.
  // Distortion of a sensor would have to bend 1.5 m of a wall by 7 cm.
  constexpr double kClearTurn = 0.006, kClearBulge = 5.0;
  if (kind == Kind::plane) return true;
  if (!noise.ofDepthCamera()) return curvature.turn > kLeastTurn;
  const double normal_noise = noise.angle / kNormalDeviations;
  const double turn = curvature.turn - normal_noise * normal_noise;
  if (turn > kClearTurn && curvature.bulge > kClearBulge) return true;
  if (turn > kLargeTurn) return curvature.bulge > kLeastBulgeOfLargeTurn;
  if (kind == Kind::sphere) return turn > kLeastTurnOfBall && curvature.bulge > kLeastBulgeOfBall;
  return turn > kLeastTurnOfDepth && curvature.bulge > kLeastBulgeOfDepth;
}

}  // namespace primitect
