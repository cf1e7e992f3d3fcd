// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists without an order tell by what is not seen of a table where their camera was.
#include "core/shadows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "primitect/moved_image.h"
#include "synthetic/clutter.h"
#include "synthetic/poses.h"
#include "test/support/point_lists.h"
#include "test/support/rendered_cloud.h"

namespace primitect::shadows_test {
namespace {

using test::averaged;
using test::listOf;
using test::pointsOf;
using test::shuffled;

const Eigen::Isometry3d kRobotFromCamera = synthetic::robotFromCamera(1.3, 0.6);

/// Of a cluttered table, in the frame of the camera.
std::vector<Vec3> table(std::uint64_t seed) {
  return pointsOf(test::renderedCloud(synthetic::clutteredTable(seed), {}, seed, synthetic::clutterPose(seed)));
}

void expectNear(const std::optional<Eigen::Isometry3d>& found, const Eigen::Isometry3d& camera,
                const std::string& what) {
  ASSERT_TRUE(found) << what;
  const Vec3 error = found->translation() - camera.translation(), ahead = found->linear().col(2);
  const double along = error.dot(ahead);
  EXPECT_LT(std::abs(along), 0.25) << what;
  EXPECT_LT((error - along * ahead).norm(), 0.06) << what;
}

TEST(FindCameraByShadows, OfTablesInVoxelsAndShuffled) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Vec3> points = table(seed);
    for (const double side : {0.005, 0.01}) {
      expectNear(findCameraByShadows(listOf(averaged(points, side), kRobotFromCamera)), kRobotFromCamera,
                 "voxels of " + std::to_string(side) + ", table " + std::to_string(seed));
    }
    expectNear(findCameraByShadows(listOf(shuffled(points, seed), kRobotFromCamera)), kRobotFromCamera,
               "shuffled table " + std::to_string(seed));
  }
}

TEST(FindCameraByShadows, InWhateverFrame) {
  const std::vector<Vec3> points = averaged(table(2), 0.005);
  const Eigen::Isometry3d far_away = Eigen::Translation3d(20.0, -30.0, 5.0) * Eigen::AngleAxisd(2.0, Vec3::UnitY());
  for (const Eigen::Isometry3d& frame_from_camera : {synthetic::robotFromCamera(0.2, 1.2), far_away})
    expectNear(findCameraByShadows(listOf(points, frame_from_camera)), frame_from_camera, "other frame");
}

TEST(FindCameraByShadows, LooksAtTheTableWithYDown) {
  const auto found = findCameraByShadows(listOf(averaged(table(3), 0.005), kRobotFromCamera));
  ASSERT_TRUE(found);
  // The camera is held upright, more or less, and looks more or less at the middle of what it sees.
  const Vec3 camera_down = kRobotFromCamera.linear().col(1), camera_ahead = kRobotFromCamera.linear().col(2);
  EXPECT_GT(found->linear().col(2).dot(camera_ahead), 0.97);
  EXPECT_GT(found->linear().col(1).dot(camera_down), 0.97);
  EXPECT_NEAR(found->linear().determinant(), 1.0, 1e-9);
}

TEST(FindCameraByShadows, NotWhereItIsAtTheOrigin) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::vector<Vec3> points = table(seed);
    EXPECT_FALSE(findCameraByShadows(listOf(shuffled(points, seed), Eigen::Isometry3d::Identity()))) << seed;
    EXPECT_FALSE(findCameraByShadows(listOf(averaged(points, 0.005), Eigen::Isometry3d::Identity()))) << seed;
  }
}

TEST(FindCameraByShadows, NotOfSeveralCameras) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::vector<Vec3> all;
    for (const double turn : {0.0, 0.7 * M_PI, 1.3 * M_PI}) {
      const Eigen::Isometry3d pose = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * synthetic::clutterPose(seed);
      for (const Vec3& point : pointsOf(test::renderedCloud(synthetic::clutteredTable(seed), {}, seed, pose)))
        all.push_back(pose * point);
    }
    EXPECT_FALSE(findCameraByShadows(listOf(averaged(all, 0.005), Eigen::Isometry3d::Identity()))) << seed;
  }
}

TEST(FindCameraByShadows, NotOfAPlaneWithNothingOnIt) {
  std::vector<Vec3> bare, endless;
  for (int i = -100; i < 100; ++i) {
    for (int k = -100; k < 100; ++k) {
      bare.push_back(Vec3(0.005 * i, 0.005 * k, -1.0));
      endless.push_back(Vec3(1e6 * i, 1e6 * k, i % 10 == 0 ? 1.0 : -1.0));
    }
  }
  EXPECT_FALSE(findCameraByShadows(listOf(bare, Eigen::Isometry3d::Identity())));
  EXPECT_FALSE(findCameraByShadows(listOf(endless, Eigen::Isometry3d::Identity())));
}

TEST(FindCameraByShadows, NotOfChanceNorOfFewPointsNorOfOnesInOnePlaceOrOnALine) {
  Random random(9);
  std::vector<Vec3> chance, line;
  for (int k = 0; k < 20000; ++k) {
    chance.push_back(Vec3{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
    line.push_back(Vec3(0.001 * k, 0.002 * k, -1.0));
  }
  EXPECT_FALSE(findCameraByShadows(listOf(chance, Eigen::Isometry3d::Identity())));
  EXPECT_FALSE(findCameraByShadows(listOf(line, Eigen::Isometry3d::Identity())));
  for (const std::size_t count : {0, 1, 3, 600}) {
    const std::vector<Vec3> place(count, Vec3(1, 2, -3));
    EXPECT_FALSE(findCameraByShadows(listOf(place, Eigen::Isometry3d::Identity()))) << count;
  }
}

TEST(SearchForCameraOfAList, LooksAtShadowsWhereTheOrderTellsNothingAndNormalsAreMissing) {
  Cloud list = listOf(averaged(table(3), 0.005), kRobotFromCamera);
  const CameraSearch found = searchForCamera(list);
  expectNear(found.cloud_from_camera, kRobotFromCamera, "without normals");
  EXPECT_EQ(found.clue, CameraClue::shadows);
  Cloud with_normals;
  with_normals.reset(list.width, 1, true);
  for (std::size_t i = 0; i < list.size(); ++i) {
    with_normals.setPoint(i, list.x[i], list.y[i], list.z[i], {});
    with_normals.setNormal(i, 0.0f, 0.0f, 1.0f);
  }
  ASSERT_TRUE(with_normals.hasNormals());
  EXPECT_FALSE(searchForCamera(with_normals).cloud_from_camera);
}

}  // namespace
}  // namespace primitect::shadows_test
