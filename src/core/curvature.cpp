// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Turn of the normals and bulge of the points; see curvature.h.
#include "core/curvature.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace primitect {

Curvature curvatureOf(const SampleSet& set) {
  Vec3 normals = Vec3::Zero(), mean = Vec3::Zero();
  double sigma = 0.0;
  for (std::size_t k = 0; k < set.size(); ++k) {
    normals += set.normal(k);
    mean += set.point(k);
    sigma += set.samples.sigma[set.indices[k]];
  }
  const double count = static_cast<double>(set.size());
  mean /= count;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < set.size(); ++k) {
    const Vec3 offset = set.point(k) - mean;
    scatter.noalias() += offset * offset.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(scatter, Eigen::EigenvaluesOnly);
  return {1.0 - normals.norm() / count, std::sqrt(std::max(0.0, solver.eigenvalues()[0] / count)) / (sigma / count)};
}

bool curvesEnough(const SampleSet& set, const NoiseModel& noise) {
  constexpr double kLeastTurn = 0.012, kLeastTurnOfDepth = 0.03;  // arcs of 31 and 49 deg
  constexpr double kLeastBulgeOfDepth = 2.0;
  if (set.size() == 0) return false;
  const Curvature curvature = curvatureOf(set);
  const double normal_noise = noise.angle / kNormalDeviations;
  if (noise.depth_share <= 0.0) return curvature.turn > kLeastTurn;
  return curvature.turn > kLeastTurnOfDepth + normal_noise * normal_noise && curvature.bulge > kLeastBulgeOfDepth;
}

}  // namespace primitect
