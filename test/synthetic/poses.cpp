// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a camera above a floor is, and what it looks at.
#include "synthetic/poses.h"

#include <gtest/gtest.h>

namespace primitect::synthetic::poses_test {
namespace {

using Eigen::Vector3d;

TEST(RobotFromCamera, PutsTheMiddleOfTheImageOnTheFloorAhead) {
  const Eigen::Isometry3d robot_from_camera = robotFromCamera(1.5, 30.0 * kDegree);
  EXPECT_LT((robot_from_camera * Vector3d(0.0, 0.0, 3.0) - Vector3d(1.5 * std::sqrt(3.0), 0.0, 0.0)).norm(), 1e-12);
  EXPECT_LT((robot_from_camera * Vector3d::Zero() - Vector3d(0.0, 0.0, 1.5)).norm(), 1e-12);
}

TEST(RobotFromCamera, HasTheImagesRightSideToTheRightAndItsLowerSideBelow) {
  const Eigen::Isometry3d robot_from_camera = robotFromCamera(1.0, 0.0);
  EXPECT_LT((robot_from_camera * Vector3d(0.2, 0.3, 2.0) - Vector3d(2.0, -0.2, 0.7)).norm(), 1e-12);
  EXPECT_NEAR(robotFromCamera(1.0, 0.4).linear().determinant(), 1.0, 1e-12);
}

}  // namespace
}  // namespace primitect::synthetic::poses_test
