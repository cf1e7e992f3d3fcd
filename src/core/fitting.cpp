// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Moment fits of the four kinds; see fitting.h. The iterations are in refinement.cpp.
#include "core/fitting.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

/// Below this share of what is possible, a spread counts as none.
constexpr double kNoSpread = 1e-9;

/// Unit eigenvector of the smallest eigenvalue.
Vec3 leastDirection(const Eigen::Matrix3d& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric).eigenvectors().col(0);
}

std::optional<Shape> planeFrom(const Moments& m) {
  const Vec3 normal = leastDirection(m.points);
  return Plane{m.mean_point, normal.dot(m.mean_normal) < 0.0 ? Vec3(-normal) : normal};
}

std::optional<Shape> sphereFrom(const Moments& m) {
  const double spread = 1.0 - m.mean_normal.squaredNorm();
  const double radius = m.mixed.trace() / spread;
  if (!(spread > kNoSpread) || !(radius > 0.0)) return std::nullopt;
  return Sphere{m.mean_point - radius * m.mean_normal, radius};
}

std::optional<Shape> cylinderFrom(const Moments& m) {
  const Vec3 axis = leastDirection(m.normals);
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  const Vec3 mean_normal = across * m.mean_normal;
  const double spread = (across * m.normals).trace() - mean_normal.squaredNorm();
  const double radius = (across * m.mixed).trace() / spread;
  if (!(spread > kNoSpread) || !(radius > 0.0)) return std::nullopt;
  return Cylinder{m.mean_point - radius * mean_normal, axis, radius};
}

std::optional<Shape> coneFrom(const Moments& m) {
  Vec3 axis = leastDirection(m.normals - m.mean_normal * m.mean_normal.transpose());
  const Eigen::LDLT<Eigen::Matrix3d> tangent_planes(m.normals);
  if (!(tangent_planes.vectorD().minCoeff() > kNoSpread)) return std::nullopt;  // parallel to a line: a cylinder
  const Vec3 apex = tangent_planes.solve(m.tangent) + m.mean_point;
  if ((m.mean_point - apex).dot(axis) < 0.0) axis = -axis;
  const double sine = -axis.dot(m.mean_normal);
  if (!(0.0 < sine && sine < 1.0) || !apex.allFinite()) return std::nullopt;
  return Cone{apex, axis, std::asin(sine)};
}

}  // namespace

Moments momentsOf(const FitPoints& points) {
  const kernels::MomentSums sums = points.moments();
  const double weight = 1.0 / static_cast<double>(points.size());
  const auto symmetric = [&](int row, int column) {
    return sums.product[std::max(row, column)][std::min(row, column)];
  };
  Moments m;
  m.count = points.size();
  m.origin = points.origin();
  const Vec3 offset = weight * Vec3(sums.sum[0], sums.sum[1], sums.sum[2]);
  m.mean_point = m.origin + offset;
  m.mean_normal = weight * Vec3(sums.sum[3], sums.sum[4], sums.sum[5]);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m.points(row, column) = weight * symmetric(row, column) - offset[row] * offset[column];
      m.normals(row, column) = weight * symmetric(3 + row, 3 + column);
      m.mixed(row, column) = weight * symmetric(row, 3 + column) - offset[row] * m.mean_normal[column];
    }
  }
  m.tangent = weight * Vec3(sums.tangent[0], sums.tangent[1], sums.tangent[2]) - m.normals * offset;
  return m;
}

Moments flipped(Moments moments) {
  moments.mean_normal = -moments.mean_normal;
  moments.mixed = -moments.mixed;
  return moments;
}

std::optional<Shape> fitFromMoments(Kind kind, const Moments& m) {
  if (m.count < 3) return std::nullopt;
  switch (kind) {
    case Kind::plane:
      return planeFrom(m);
    case Kind::sphere:
      return sphereFrom(m);
    case Kind::cylinder:
      return cylinderFrom(m);
    case Kind::cone:
      break;
  }
  return coneFrom(m);
}

}  // namespace primitect
