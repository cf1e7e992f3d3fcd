// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes, detections and covariances in another frame.
#include "primitect/transforms.h"

namespace primitect {
namespace {

struct Transform {
  const Eigen::Isometry3d& target_from_source;

  Vec3 turn(const Vec3& direction) const { return target_from_source.linear() * direction; }

  Shape operator()(const Plane& p) const { return Plane{target_from_source * p.point, turn(p.normal)}; }
  Shape operator()(const Sphere& s) const { return Sphere{target_from_source * s.center, s.radius}; }
  Shape operator()(const Cylinder& c) const { return Cylinder{target_from_source * c.point, turn(c.axis), c.radius}; }
  Shape operator()(const Cone& c) const { return Cone{target_from_source * c.apex, turn(c.axis), c.half_angle}; }
};

void transformExtent(const Eigen::Isometry3d& target_from_source, Extent& extent) {
  extent.origin = target_from_source * extent.origin;
  extent.rotation = target_from_source.linear() * extent.rotation;
  for (Vec3& corner : extent.hull) corner = target_from_source * corner;
}

}  // namespace

Shape transformed(const Eigen::Isometry3d& target_from_source, const Shape& shape) {
  return std::visit(Transform{target_from_source}, shape);
}

void transformDetections(const Eigen::Isometry3d& target_from_source, Detections& detections) {
  for (Detection& detection : detections.items) {
    detection.shape = transformed(target_from_source, detection.shape);
    transformExtent(target_from_source, detection.extent);
    turnCovariance(target_from_source.linear(), detection.covariance.data());
  }
}

void turnCovariance(const Eigen::Matrix3d& rotation, double* covariance) {
  using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  if (covariance[0] < 0.0) return;
  Matrix6 both = Matrix6::Zero();
  both.topLeftCorner<3, 3>() = rotation;
  both.bottomRightCorner<3, 3>() = rotation;
  Eigen::Map<Matrix6> values(covariance);
  values = (both * values * both.transpose()).eval();
}

}  // namespace primitect
