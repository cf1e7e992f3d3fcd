// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The direction in which the neighbours spread least.
#include "synthetic/pca_normals.h"

#include <Eigen/Eigenvalues>
#include <cstdint>

#include "synthetic/neighbor_grid.h"

namespace primitect::synthetic {
namespace {

Vec3 normalByPca(const Cloud& cloud, const std::vector<std::uint32_t>& neighbors) {
  Vec3 mean = Vec3::Zero();
  for (const std::uint32_t j : neighbors) mean += cloud.point(j);
  mean /= static_cast<double>(neighbors.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const std::uint32_t j : neighbors) {
    const Vec3 offset = cloud.point(j) - mean;
    covariance.noalias() += offset * offset.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  return solver.eigenvectors().col(0);
}

}  // namespace

void estimateNormals(Cloud& cloud, double cell, const std::vector<Vec3>& outward, std::size_t neighbors) {
  NeighborGrid grid(cloud, static_cast<float>(cell));
  std::vector<std::uint32_t> nearest;
  for (const std::uint32_t i : grid.order()) {
    grid.nearest(i, neighbors, nearest);
    Vec3 normal = normalByPca(cloud, nearest);
    if (normal.dot(outward[i]) < 0.0) normal = -normal;
    cloud.setNormal(i, static_cast<float>(normal.x()), static_cast<float>(normal.y()), static_cast<float>(normal.z()));
  }
}

}  // namespace primitect::synthetic
