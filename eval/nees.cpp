// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Errors of pose and sizes over their claimed spread; see nees.h.
#include "eval/nees.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/covariance.h"
#include "core/symmetric_eigen.h"

namespace primitect::eval {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// From the detection to the truth: shift of the origin and turn, about the fixed axes of the cloud's frame.
struct PoseError {
  Vec3 shift = Vec3::Zero(), turn = Vec3::Zero();
  /// Columns: the directions in which the kind has such an error.
  Eigen::Matrix3Xd shift_directions, turn_directions;
};

/// Turn about an axis across both that takes one to the other; exact for small and large angles.
Vec3 turnBetween(const Vec3& found, const Vec3& truth) {
  const Vec3 across = found.cross(truth);
  const double sine = across.norm();
  return sine > 0.0 ? Vec3(across / sine * std::atan2(sine, found.dot(truth))) : Vec3::Zero();
}

Eigen::Matrix<double, 3, 2> acrossOf(const Vec3& axis) {
  Eigen::Matrix<double, 3, 2> directions;
  directions.col(0) = axis.unitOrthogonal();
  directions.col(1) = axis.cross(directions.col(0));
  return directions;
}

PoseError poseError(const Plane& truth, const Plane& found, const Vec3& origin) {
  const Vec3 normal = truth.normal.dot(found.normal) < 0.0 ? Vec3(-truth.normal) : truth.normal;
  const double away = (truth.point - origin).dot(normal) / normal.dot(found.normal);
  return {away * found.normal, turnBetween(found.normal, normal), found.normal, acrossOf(found.normal)};
}

PoseError poseError(const Sphere& truth, const Sphere&, const Vec3& origin) {
  return {truth.center - origin, Vec3::Zero(), Eigen::Matrix3d::Identity(), Eigen::Matrix3Xd(3, 0)};
}

/// The true axis is compared where it passes the plane through the origin across the axis that was found.
PoseError poseError(const Cylinder& truth, const Cylinder& found, const Vec3& origin) {
  const Vec3 axis = truth.axis.dot(found.axis) < 0.0 ? Vec3(-truth.axis) : truth.axis;
  const Vec3 offset = truth.point - origin;
  const Vec3 shift = offset - offset.dot(found.axis) / axis.dot(found.axis) * axis;
  return {shift, turnBetween(found.axis, axis), acrossOf(found.axis), acrossOf(found.axis)};
}

PoseError poseError(const Cone& truth, const Cone& found, const Vec3& origin) {
  const double height = (origin - found.apex).dot(found.axis);
  return {truth.apex + height * truth.axis - origin, turnBetween(found.axis, truth.axis), Eigen::Matrix3d::Identity(),
          acrossOf(found.axis)};
}

/// Over the given directions (columns of pairs shift, turn) without those that are called unobservable.
std::optional<NormalisedError> normalised(const Matrix6& covariance, const Vector6& error,
                                          const Eigen::Matrix<double, 6, Eigen::Dynamic>& directions) {
  if (directions.cols() == 0) return std::nullopt;
  // With more digits, as variances of 1e6 cancel out.
  const auto exactly = directions.cast<long double>().eval();
  const auto spread = covariance.cast<long double>().lazyProduct(exactly).eval();
  // The rest of the matrix stands for directions that are left out below. Fixed sizes and lazy products are compiled in
  // a tenth of the time.
  static_assert(kUnobservable >= kLeastUnobservable);
  Matrix6 part = kUnobservable * Matrix6::Identity();
  part.topLeftCorner(directions.cols(), directions.cols()) = exactly.transpose().lazyProduct(spread).cast<double>();
  const SymmetricEigen eigen = eigenOf(part);
  Vector6 off = Vector6::Zero();
  off.head(directions.cols()) = directions.transpose().lazyProduct(error);
  const Vector6 along = eigen.vectors.transpose() * off;
  NormalisedError result;
  for (Eigen::Index k = 0; k < along.size(); ++k) {
    const double variance = eigen.values[k];
    if (variance >= kLeastUnobservable) continue;
    if (!(variance > 0.0)) return std::nullopt;
    result.value += along[k] * along[k] / variance;
    ++result.degrees;
  }
  return result.degrees > 0 ? std::optional<NormalisedError>(result) : std::nullopt;
}

std::optional<NormalisedError> normalised(double error, float stddev) {
  if (!(stddev > 0.0f)) return std::nullopt;
  return NormalisedError{error * error / (static_cast<double>(stddev) * stddev), 1};
}

void addSizes(const Plane&, const Plane&, const Detection&, NormalisedErrors&) {}

void addSizes(const Sphere& truth, const Sphere& found, const Detection& detection, NormalisedErrors& errors) {
  errors.radius = normalised(truth.radius - found.radius, detection.radius_stddev);
}

void addSizes(const Cylinder& truth, const Cylinder& found, const Detection& detection, NormalisedErrors& errors) {
  errors.radius = normalised(truth.radius - found.radius, detection.radius_stddev);
}

void addSizes(const Cone& truth, const Cone& found, const Detection& detection, NormalisedErrors& errors) {
  const double radius = detection.extent.radius;
  const Vec3 wide_end = found.apex + radius / std::tan(found.half_angle) * found.axis;
  const double true_radius = (wide_end - truth.apex).dot(truth.axis) * std::tan(truth.half_angle);
  errors.radius = normalised(true_radius - radius, detection.radius_stddev);
  errors.half_angle = normalised(truth.half_angle - found.half_angle, detection.half_angle_stddev);
}

void addPose(const PoseError& pose, const Detection& detection, NormalisedErrors& errors) {
  if (!(detection.covariance[0] >= 0.0)) return;
  const Matrix6 covariance =
      Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(detection.covariance.data());
  Vector6 error;
  error << pose.shift, pose.turn;
  const Eigen::Index shifts = pose.shift_directions.cols(), turns = pose.turn_directions.cols();
  Eigen::Matrix<double, 6, Eigen::Dynamic> directions = Eigen::MatrixXd::Zero(6, shifts + turns);
  directions.topLeftCorner(3, shifts) = pose.shift_directions;
  directions.bottomRightCorner(3, turns) = pose.turn_directions;
  errors.origin = normalised(covariance, error, directions.leftCols(shifts));
  errors.axis = normalised(covariance, error, directions.rightCols(turns));
  errors.pose = normalised(covariance, error, directions);
}

}  // namespace

std::optional<NormalisedError> NormalisedErrors::total(Kind kind) const {
  if (kind == Kind::plane || !pose) return pose;
  const std::optional<NormalisedError>& size = kind == Kind::cone ? half_angle : radius;
  if (!size) return std::nullopt;
  return NormalisedError{pose->value + size->value, pose->degrees + size->degrees};
}

NormalisedErrors normalisedErrors(const Shape& truth, const Detection& found) {
  if (kindOf(truth) != kindOf(found.shape)) {
    throw std::invalid_argument(std::string("normalised errors: a ") + kindName(kindOf(found.shape)) +
                                " compared with a " + kindName(kindOf(truth)));
  }
  NormalisedErrors errors;
  std::visit(
      [&](const auto& true_shape) {
        const auto& shape = std::get<std::decay_t<decltype(true_shape)>>(found.shape);
        addPose(poseError(true_shape, shape, found.extent.origin), found, errors);
        addSizes(true_shape, shape, found, errors);
      },
      truth);
  return errors;
}

}  // namespace primitect::eval
