// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Moment fits of the four kinds; see fitting.h. The iterations are in refinement.cpp.
#include "core/fitting.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

/// Below this share of what is possible, a spread counts as none.
constexpr double kNoSpread = 1e-9;

/// Means over the set; points are taken relative to the mean point, for the sake of rounding.
struct Moments {
  Vec3 mean_point = Vec3::Zero();
  Vec3 mean_normal = Vec3::Zero();
  Eigen::Matrix3d points = Eigen::Matrix3d::Zero();   ///< E[p p'], p from the mean point
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();  ///< E[n n']
  Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero();    ///< E[p n']
  Vec3 tangent = Vec3::Zero();                        ///< E[n n' p]
};

Moments momentsOf(const SampleSet& set) {
  Moments m;
  const double weight = 1.0 / static_cast<double>(set.size());
  for (std::size_t k = 0; k < set.size(); ++k) {
    m.mean_point += weight * set.point(k);
    m.mean_normal += weight * set.normal(k);
  }
  for (std::size_t k = 0; k < set.size(); ++k) {
    const Vec3 p = set.point(k) - m.mean_point;
    const Vec3 n = set.normal(k);
    m.points.noalias() += weight * p * p.transpose();
    m.normals.noalias() += weight * n * n.transpose();
    m.mixed.noalias() += weight * p * n.transpose();
    m.tangent += weight * n.dot(p) * n;
  }
  return m;
}

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

std::optional<Shape> fitFromMoments(Kind kind, const SampleSet& set) {
  if (set.size() < 3) return std::nullopt;
  const Moments m = momentsOf(set);
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
