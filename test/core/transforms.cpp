// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What was found, in another frame.
#include "primitect/transforms.h"

#include <gtest/gtest.h>

#include "test/support/scenes.h"

namespace primitect::transforms_test {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

Eigen::Isometry3d somePose() {
  return Eigen::Translation3d(1.0, -2.0, 3.0) * Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized());
}

TEST(Transforms, KeepDistancesAndTurnNormals) {
  const Eigen::Isometry3d pose = somePose();
  Random random(3);
  for (const Shape& shape : {Shape(test::kTable), Shape(test::kBall), Shape(test::kCan), Shape(test::kHat)}) {
    const Shape moved = transformed(pose, shape);
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = test::randomPoint(random);
      EXPECT_NEAR(distance(moved, pose * p), distance(shape, p), 1e-12);
      EXPECT_LT((normalAt(moved, pose * p) - pose.linear() * normalAt(shape, p)).norm(), 1e-9);
    }
  }
}

TEST(Transforms, MoveWhatWasSeenWithTheShape) {
  Detections detections;
  detections.items.resize(1);
  Detection& plane = detections.items[0];
  plane.shape = test::kTable;
  plane.extent.origin = test::kTable.point;
  const Vec3 across = test::kTable.normal.unitOrthogonal();
  plane.extent.rotation << across, test::kTable.normal.cross(across), test::kTable.normal;
  plane.extent.size = Vec3(0.2, 0.1, 0.0);
  plane.extent.hull = {plane.extent.origin + 0.1 * plane.extent.rotation.col(0)};
  const Extent before = plane.extent;
  transformDetections(somePose(), detections);
  const Vec3 normal = std::get<Plane>(plane.shape).normal;
  EXPECT_LT((plane.extent.origin - somePose() * before.origin).norm(), 1e-12);
  EXPECT_LT((plane.extent.rotation.col(2) - normal).norm(), 1e-12);
  EXPECT_LT((plane.extent.hull[0] - plane.extent.origin - 0.1 * plane.extent.rotation.col(0)).norm(), 1e-12);
  EXPECT_EQ(plane.extent.size, before.size);
  EXPECT_EQ(plane.covariance[0], -1.0) << "unknown stays unknown";
}

TEST(Transforms, TurnErrorsOfPositionAndTurnLikewise) {
  Matrix6 root = Matrix6::Zero();
  for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = std::sin(3.0 * i);
  const Matrix6 covariance = root * root.transpose();
  Detections detections;
  detections.items.resize(1);
  Eigen::Map<Matrix6>(detections.items[0].covariance.data()) = covariance;
  transformDetections(somePose(), detections);
  const Matrix6 moved = Eigen::Map<Matrix6>(detections.items[0].covariance.data());
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const Vec3 shift = test::randomDirection(random), turn = test::randomDirection(random);
    Eigen::Matrix<double, 6, 1> along, along_moved;
    along << shift, turn;
    along_moved << somePose().linear() * shift, somePose().linear() * turn;
    EXPECT_NEAR(along_moved.dot(moved * along_moved), along.dot(covariance * along), 1e-9);
  }
}

}  // namespace
}  // namespace primitect::transforms_test
