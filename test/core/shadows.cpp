// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists without an order tell by what is not seen of a table where their camera was.
#include "core/shadows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/random.h"
#include "primitect/moved_image.h"
#include "synthetic/clutter.h"
#include "synthetic/poses.h"
#include "test/support/ball_and_wall.h"
#include "test/support/point_lists.h"
#include "test/support/rendered_cloud.h"

namespace primitect::shadows_test {
namespace {

using test::averaged;
using test::listOf;
using test::pointsOf;
using test::shuffled;

const Eigen::Isometry3d kRobotFromCamera = synthetic::robotFromCamera(1.3, 0.6);

/// Of a cluttered table in a room, in the frame of the camera; all of it, or as a depth cut leaves it.
std::vector<Vec3> table(std::uint64_t seed, float max_depth = 2.0f, bool projector_shadows = false) {
  synthetic::FrameParams params;
  params.truth.range.max = max_depth;
  params.noise.shadows = projector_shadows;
  return pointsOf(test::renderedCloud(synthetic::clutteredTable(seed), params, seed, synthetic::clutterPose(seed)));
}

/// As a voxel grid leaves them, whose cubes are along the axes of the frame that the points were moved to.
Cloud inVoxels(const std::vector<Vec3>& points, double side, const Eigen::Isometry3d& frame_from_camera) {
  std::vector<Vec3> moved;
  for (const Vec3& point : points) moved.push_back(frame_from_camera * point);
  return listOf(averaged(moved, side), Eigen::Isometry3d::Identity());
}

/// Across the line of sight much better than along it.
void expectNear(const std::optional<Eigen::Isometry3d>& found, const Eigen::Isometry3d& camera, const std::string& what,
                double most_across = 0.06) {
  ASSERT_TRUE(found) << what;
  const Vec3 error = found->translation() - camera.translation(), ahead = found->linear().col(2);
  const double along = error.dot(ahead);
  EXPECT_LT(std::abs(along), 0.25) << what;
  EXPECT_LT((error - along * ahead).norm(), most_across) << what;
}

TEST(FindCameraByShadows, OfTablesInVoxelsAndShuffled) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Vec3> points = table(seed);
    const std::string name = ", table " + std::to_string(seed);
    expectNear(findCameraByShadows(inVoxels(points, 0.005, kRobotFromCamera)), kRobotFromCamera, "5 mm" + name);
    expectNear(findCameraByShadows(inVoxels(points, 0.01, kRobotFromCamera)), kRobotFromCamera, "10 mm" + name);
    expectNear(findCameraByShadows(listOf(shuffled(points, seed), kRobotFromCamera)), kRobotFromCamera,
               "shuffled" + name);
  }
}

TEST(FindCameraByShadows, WhereWallsAreSeenFarBehindTheTable) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    expectNear(findCameraByShadows(inVoxels(table(seed, 10.0f), 0.005, kRobotFromCamera)), kRobotFromCamera,
               "room " + std::to_string(seed));
  }
}

/// The projector, 75 mm beside the camera, casts shadows, too.
TEST(FindCameraByShadows, WhereStructuredLightHasShadowsOfItsOwn) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    expectNear(findCameraByShadows(inVoxels(table(seed, 2.0f, true), 0.005, kRobotFromCamera)), kRobotFromCamera,
               "projector " + std::to_string(seed), 0.08);
  }
}

TEST(FindCameraByShadows, InWhateverFrame) {
  const std::vector<Vec3> points = table(2);
  const Eigen::Isometry3d far_away = Eigen::Translation3d(600.0, -900.0, 5.0) * Eigen::AngleAxisd(2.0, Vec3::UnitY());
  for (const Eigen::Isometry3d& frame_from_camera : {synthetic::robotFromCamera(0.2, 1.2), far_away})
    expectNear(findCameraByShadows(listOf(shuffled(points, 1), frame_from_camera)), frame_from_camera, "other frame");
}

TEST(FindCameraByShadows, LooksAtTheTableWithYDown) {
  const auto found = findCameraByShadows(inVoxels(table(3), 0.005, kRobotFromCamera));
  ASSERT_TRUE(found);
  // The camera is held upright, more or less, and looks more or less at the middle of what it sees.
  const Vec3 camera_down = kRobotFromCamera.linear().col(1), camera_ahead = kRobotFromCamera.linear().col(2);
  EXPECT_GT(found->linear().col(2).dot(camera_ahead), 0.97);
  EXPECT_GT(found->linear().col(1).dot(camera_down), 0.97);
  EXPECT_NEAR(found->linear().determinant(), 1.0, 1e-9);
}

/// As in camera_link, whose x axis is ahead.
TEST(FindCameraByShadows, IsAtTheOriginWhereOnlyTheAxesAreOthers) {
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned.linear() << Vec3(0, -1, 0), Vec3(0, 0, -1), Vec3(1, 0, 0);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Cloud list = listOf(shuffled(table(seed), seed), turned);
    ASSERT_TRUE(mayTellByShadows(list));
    const auto found = findCameraByShadows(list);
    ASSERT_TRUE(found) << seed;
    EXPECT_LT(found->translation().norm(), 1e-5) << seed;
    EXPECT_GT(found->linear().col(2).dot(Vec3::UnitX()), 0.97) << seed;
  }
}

/// Below the image of the table the camera sees the floor, .7 m lower.
TEST(FindCameraByShadows, OfATableBesideWhichMoreOfTheFloorIsSeen) {
  std::vector<Vec3> points = table(2);
  const Vec3 up = synthetic::clutterPose(2).linear().transpose() * Vec3::UnitZ();
  double on_table = 0.0, lowest = -1.0;
  for (const Vec3& point : points)
    on_table = std::min(on_table, up.dot(point)), lowest = std::max(lowest, point.y() / point.z());
  Random random(2);
  const std::size_t floor_points = points.size() / 3;
  for (std::size_t k = 0; k < floor_points; ++k) {
    const Vec3 ray{random.uniform(-0.5, 0.5), random.uniform(lowest + 0.02, lowest + 0.4), 1.0};
    points.push_back((on_table - 0.7) / up.dot(ray) * ray);
  }
  expectNear(findCameraByShadows(listOf(shuffled(points, 1), kRobotFromCamera)), kRobotFromCamera, "floor");
}

TEST(FindCameraByShadows, OnlyWhereTheyTellHowFarItIs) {
  const auto listWith = [](const Sphere& ball) {
    return listOf(shuffled(pointsOf(test::BallAndWall{2, 1.2, ball}.image(1)), 1), kRobotFromCamera);
  };
  expectNear(findCameraByShadows(listWith({Vec3(0.05, 0.02, 0.8), 0.1})), kRobotFromCamera, "far from the wall");
  EXPECT_FALSE(findCameraByShadows(listWith({Vec3(0.05, 0.02, 1.0), 0.05})));
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

/// Only the table under them is not seen.
TEST(FindCameraByShadows, NotOfLowBoxesThatWereScannedFromAllSides) {
  constexpr double kStep = 0.005, kHalf = 0.05;
  std::vector<Vec3> scan;
  for (int i = -100; i <= 100; ++i) {
    for (int k = -100; k <= 100; ++k) {
      const Vec3 place(kStep * i, kStep * k, 0.0);
      const auto within = [&](double x, double y) {
        return std::max(std::abs(place.x() - x), std::abs(place.y() - y)) < kHalf;
      };
      const bool box = within(0.2, 0.1) || within(-0.2, 0.2) || within(0.1, -0.25) || within(-0.25, -0.2);
      scan.push_back(place + (box ? 0.04 : 0.0) * Vec3::UnitZ());
    }
  }
  EXPECT_FALSE(findCameraByShadows(listOf(scan, Eigen::Isometry3d::Identity())));
}

/// Two fifths of what is seen were not measured, in squares as on a chessboard.
TEST(FindCameraByShadows, NotWhereMostHolesAreNoShadows) {
  std::vector<Vec3> points = table(2);
  ASSERT_TRUE(findCameraByShadows(listOf(shuffled(points, 1), kRobotFromCamera)));
  const auto is_lost = [](const Vec3& point) {
    const double u = 16.0 * point.x() / point.z(), v = 16.0 * point.y() / point.z();
    return std::lround(u) % 2 == 0 && std::abs(v - std::round(v)) < 0.4;
  };
  points.erase(std::remove_if(points.begin(), points.end(), is_lost), points.end());
  EXPECT_FALSE(findCameraByShadows(listOf(shuffled(points, 1), kRobotFromCamera)));
}

/// As another camera sees it under the table.
TEST(FindCameraByShadows, NotWherePointsWouldBeHiddenFromThere) {
  const std::vector<Vec3> points = table(2);
  std::vector<Vec3> with_hidden = points;
  for (std::size_t k = 0; k < points.size(); k += 10) with_hidden.push_back(1.3 * points[k]);
  ASSERT_TRUE(findCameraByShadows(listOf(shuffled(points, 1), kRobotFromCamera)));
  EXPECT_FALSE(findCameraByShadows(listOf(shuffled(with_hidden, 1), kRobotFromCamera)));
}

TEST(FindCameraByShadows, NotOfAPlaneWithNothingOnItNorOfAnEndlessOne) {
  std::vector<Vec3> bare, endless;
  for (int i = -90; i < 90; ++i) {
    for (int k = -90; k < 90; ++k) {
      bare.push_back(Vec3(0.005 * i, 0.005 * k, -1.0));
      endless.push_back(Vec3(1e4 * i, 1e4 * k, i % 10 == 0 ? 1.0 : -1.0));
    }
  }
  EXPECT_FALSE(findCameraByShadows(listOf(bare, Eigen::Isometry3d::Identity())));
  const Cloud list = listOf(endless, Eigen::Isometry3d::Identity());
  ASSERT_EQ(list.valid_count, endless.size());
  EXPECT_FALSE(findCameraByShadows(list));
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

TEST(MayTellByShadows, AListThatWasNotSeenFromTheOrigin) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::vector<Vec3> points = table(seed);
    EXPECT_FALSE(mayTellByShadows(listOf(shuffled(points, seed), Eigen::Isometry3d::Identity()))) << seed;
    EXPECT_FALSE(mayTellByShadows(listOf(averaged(points, 0.005), Eigen::Isometry3d::Identity()))) << seed;
    EXPECT_TRUE(mayTellByShadows(listOf(shuffled(points, seed), kRobotFromCamera))) << seed;
  }
  EXPECT_FALSE(mayTellByShadows(listOf(std::vector<Vec3>(400, -Vec3::UnitZ()), kRobotFromCamera))) << "few points";
  Cloud image = listOf(table(1), kRobotFromCamera);
  image.width /= 2, image.height = 2;
  EXPECT_FALSE(mayTellByShadows(image)) << "it has rows and columns";
}

TEST(SearchForCameraOfAList, LooksAtShadowsWhereTheOrderTellsNothingAndNormalsAreMissing) {
  const Cloud list = inVoxels(table(3), 0.005, kRobotFromCamera);
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

TEST(SearchForCameraInCut, LooksForShadowsInWhatWasNotCut) {
  const Cloud whole = inVoxels(table(3), 0.005, kRobotFromCamera);
  const auto in_whole = searchForCameraInCut(whole);
  ASSERT_TRUE(in_whole);
  expectNear(in_whole->cloud_from_camera, kRobotFromCamera, "nothing was cut off");
  Cloud cut = whole;
  cut.move(Eigen::Isometry3d::Identity(), {-1.0f, 0.6f});
  ASSERT_LT(cut.valid_count, cut.size());
  ASSERT_GT(cut.valid_count, cut.size() / 2);
  EXPECT_FALSE(searchForCameraInCut(cut));
}

}  // namespace
}  // namespace primitect::shadows_test
