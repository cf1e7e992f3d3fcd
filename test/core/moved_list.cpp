// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists of the points of an image tell by their order where its camera was.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/listed_image.h"
#include "core/random.h"
#include "primitect/moved_image.h"
#include "synthetic/clutter.h"
#include "synthetic/poses.h"
#include "test/support/point_lists.h"
#include "test/support/rendered_cloud.h"

namespace primitect::moved_list_test {
namespace {

using test::averaged;
using test::pointsOf;
using test::shuffled;

const Eigen::Isometry3d kRobotFromCamera = synthetic::robotFromCamera(1.3, 0.6);

Cloud table(std::uint64_t seed) {
  return test::renderedCloud(synthetic::clutteredTable(seed), {}, seed, synthetic::clutterPose(seed));
}

/// In the frame of a robot, unless another is given.
Cloud listOf(const std::vector<Vec3>& points, const Eigen::Isometry3d& frame_from_camera = kRobotFromCamera) {
  return test::listOf(points, frame_from_camera);
}

std::vector<Vec3> those(const std::vector<Vec3>& points, const std::function<bool(const Vec3&)>& stay) {
  std::vector<Vec3> left;
  std::copy_if(points.begin(), points.end(), std::back_inserter(left), stay);
  return left;
}

void expectFound(const std::vector<Vec3>& points, const Eigen::Isometry3d& pose, const std::string& what) {
  const auto found = findCamera(listOf(points, pose));
  ASSERT_TRUE(found) << what;
  EXPECT_LT((found->translation() - pose.translation()).norm(), 0.002) << what;
  EXPECT_LT(Eigen::AngleAxisd(found->linear().transpose() * pose.linear()).angle(), 0.002) << what;
}

TEST(FindCameraOfAList, InAnyFrame) {
  Eigen::Isometry3d on_side = Eigen::Isometry3d::Identity();
  on_side.translate(Vec3(-3.0, 20.0, 5.0)).rotate(Eigen::AngleAxisd(1.5, Vec3(1, 2, -1).normalized()));
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const Eigen::Isometry3d& pose : {kRobotFromCamera, synthetic::robotFromCamera(2.5, 1.5), on_side,
                                          Eigen::Isometry3d(Eigen::Isometry3d::Identity())}) {
      expectFound(pointsOf(table(seed)), pose, "table " + std::to_string(seed));
    }
  }
}

TEST(FindCameraOfAList, AfterFilters) {
  Random random(5);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Vec3> all = pointsOf(table(seed));
    const std::string table_text = ", table " + std::to_string(seed);
    expectFound(those(all, [](const Vec3& p) { return std::abs(p.x()) < 0.2 && std::abs(p.y()) < 0.15; }),
                kRobotFromCamera, "a box" + table_text);
    expectFound(those(all, [&](const Vec3&) { return random.uniform() < 0.5; }), kRobotFromCamera,
                "half of the points" + table_text);
    expectFound(those(all, [&](const Vec3&) { return random.uniform() < 0.97; }), kRobotFromCamera,
                "without outliers" + table_text);
    expectFound(those(all, [](const Vec3& p) { return p.x() < -0.2 * p.z(); }), kRobotFromCamera,
                "one side" + table_text);
  }
}

/// In which any axis would meet all lines between points, if it were not for their noise.
TEST(FindCameraOfAList, FromATableAlone) {
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 1.0}, test::tableBeforeCamera(1.0, 0.7));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Vec3> all = pointsOf(test::renderedCloud(world, {}, seed));
    expectFound(all, kRobotFromCamera, "all of it");
    expectFound(those(all, [](const Vec3& p) { return std::abs(p.x()) < 0.1 && std::abs(p.y()) < 0.1; }),
                kRobotFromCamera, "a part of it");
  }
}

TEST(FindCameraOfAList, WhicheverWayColumnsAndRowsRun) {
  const Cloud image = table(2);
  std::vector<Vec3> down, backwards = pointsOf(image);
  for (std::size_t column = 0; column < image.width; ++column) {
    for (std::size_t i = column; i < image.size(); i += image.width) {
      if (image.valid(i)) down.push_back(image.point(i));
    }
  }
  std::reverse(backwards.begin(), backwards.end());
  for (const std::vector<Vec3>& points : {down, backwards}) {
    const auto found = findCamera(listOf(points));
    ASSERT_TRUE(found);
    EXPECT_LT((found->translation() - kRobotFromCamera.translation()).norm(), 0.002);
    EXPECT_NEAR(found->linear().col(2).dot(kRobotFromCamera.linear().col(2)), 1.0, 1e-6) << "it looks ahead";
    const auto at_origin = findCamera(listOf(points, Eigen::Isometry3d::Identity()));
    ASSERT_TRUE(at_origin);
    EXPECT_TRUE(isAtOrigin(*at_origin, listOf(points)));
  }
}

TEST(FindCameraOfAList, WhateverAFewStraysSay) {
  Random random(3);
  std::vector<Vec3> aside = pointsOf(table(1)), at_camera = aside;
  for (Vec3& point : aside) {
    if (random.uniform() < 0.02) point.x() += 0.2 * random.gaussian();
  }
  for (Vec3& point : at_camera) {
    // As points of which nothing was measured, at (0, 0, 0), that were moved with the others.
    if (random.uniform() < 0.03) point = Vec3::Zero();
  }
  expectFound(aside, kRobotFromCamera, "aside");
  expectFound(at_camera, kRobotFromCamera, "at the camera");
}

TEST(FindCameraOfAList, WherePointsAreMissingInTheList) {
  std::vector<Vec3> points = pointsOf(table(2));
  Cloud list = listOf(points);
  Random random(4);
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (random.uniform() < 0.1 || i % 3000 < 700) list.x[i] = list.y[i] = list.z[i] = none;
  }
  list.countPoints();
  const auto found = findCamera(list);
  ASSERT_TRUE(found);
  EXPECT_LT((found->translation() - kRobotFromCamera.translation()).norm(), 0.002);
}

TEST(FindCameraOfAList, NotWithoutTheOrderOfTheImage) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Vec3> points = pointsOf(table(seed));
    for (const double side : {0.003, 0.005, 0.01}) {
      EXPECT_FALSE(findCamera(listOf(averaged(points, side)))) << "voxels of " << side << ", table " << seed;
    }
    EXPECT_FALSE(findCamera(listOf(shuffled(points, seed)))) << "shuffled table " << seed;
  }
}

TEST(FindCameraOfAList, NotOfTwoCameras) {
  const std::vector<Vec3> first = pointsOf(table(1)), second = pointsOf(table(2));
  const Eigen::Isometry3d to_the_back = Eigen::Translation3d(0.0, 0.0, -0.2) * Eigen::AngleAxisd(M_PI, Vec3::UnitY());
  for (const Eigen::Isometry3d& first_from_second : {synthetic::robotFromCamera(0.5, 0.2), to_the_back}) {
    for (const double share : {1.0, 0.5, 0.2}) {
      std::vector<Vec3> both = first;
      const auto end = second.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(second.size()));
      std::transform(second.begin(), end, std::back_inserter(both),
                     [&](const Vec3& point) { return Vec3(first_from_second * point); });
      EXPECT_FALSE(findCamera(listOf(both))) << share;
    }
  }
}

TEST(FindCameraOfAList, NotOfALaserScannerNorOfChance) {
  std::vector<Vec3> by_column, by_row, chance;
  Random random(9);
  const auto seen = [](int azimuth, int elevation) {
    const double a = 0.0035 * azimuth, e = 0.035 * elevation,
                 far = 1.2 + 0.3 * std::sin(5.0 * a) + 0.2 * std::cos(7.0 * e);
    return Vec3(far * std::sin(a) * std::cos(e), far * std::sin(e), far * std::cos(a) * std::cos(e));
  };
  for (int a = -150; a < 150; ++a) {
    for (int e = -8; e < 8; ++e) by_column.push_back(seen(a, e));
  }
  for (int e = -8; e < 8; ++e) {
    for (int a = -150; a < 150; ++a) by_row.push_back(seen(a, e));
  }
  for (int k = 0; k < 20000; ++k) chance.push_back(Vec3{random.uniform(), random.uniform(), random.uniform()});
  EXPECT_FALSE(findCamera(listOf(by_column)));
  EXPECT_FALSE(findCamera(listOf(by_row)));
  EXPECT_FALSE(findCamera(listOf(chance)));
}

TEST(FindCameraOfAList, NotOfFewPointsOrOnesInOnePlaceOrOnALine) {
  EXPECT_FALSE(findCamera(Cloud()));
  EXPECT_TRUE(findPixels(Cloud()).empty());
  for (const int count : {1, 3, 60, 2000}) {
    std::vector<Vec3> line;
    for (int k = 0; k < count; ++k) line.push_back(Vec3(0.001 * k, 0.002 * k, 1.0));
    EXPECT_FALSE(findCamera(listOf(line))) << count;
    EXPECT_FALSE(findCamera(listOf(std::vector<Vec3>(static_cast<std::size_t>(count), Vec3(1, 2, 3))))) << count;
  }
}

TEST(SearchForCameraOfAList, FindsItWhereItsOrderTells) {
  const std::vector<Vec3> points = pointsOf(table(3));
  const auto of_camera = searchForCameraInCut(listOf(points, Eigen::Isometry3d::Identity()));
  const auto moved = searchForCameraInCut(listOf(points));
  ASSERT_TRUE(of_camera && moved) << "nothing was cut off";
  EXPECT_TRUE(of_camera->at_origin);
  EXPECT_FALSE(of_camera->cloud_from_camera);
  EXPECT_FALSE(moved->at_origin);
  EXPECT_TRUE(moved->cloud_from_camera);
  EXPECT_EQ(moved->clue, CameraClue::order);
  const auto none = searchForCameraInCut(listOf(shuffled(points, 1), Eigen::Isometry3d::Identity()));
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->at_origin);
  EXPECT_FALSE(none->cloud_from_camera);
}

TEST(SearchForCameraOfAList, LooksAtAllOfItWhereMostWasCutOff) {
  const Eigen::Isometry3d pose = synthetic::robotFromCamera(0.3, 0.9);
  const Cloud whole = listOf(pointsOf(table(3)), pose);
  Cloud cut = whole;
  cut.move(Eigen::Isometry3d::Identity(), {0.1f, 2.0f});
  ASSERT_LT(cut.valid_count, cut.size() / 2);
  EXPECT_FALSE(searchForCameraInCut(cut));
  const auto found = searchForCamera(whole).cloud_from_camera;
  ASSERT_TRUE(found);
  EXPECT_LT((found->translation() - pose.translation()).norm(), 0.002);
}

/// Columns and rows are whole numbers, and those of the image but for where they begin.
TEST(FindPixels, AreThoseOfTheImage) {
  const Cloud image = table(4);
  const std::vector<SeenPoint> seen = findPixels(listOf(pointsOf(image), Eigen::Isometry3d::Identity()));
  ASSERT_GT(seen.size(), 400u);
  const double focal_length = synthetic::PinholeCamera().fx;
  const auto trueOf = [&](const SeenPoint& each) {
    return Eigen::Vector2d(focal_length * each.point.head<2>() / each.point.z());
  };
  const Eigen::Vector2d shift = seen.front().pixel - trueOf(seen.front());
  for (const SeenPoint& each : seen) {
    EXPECT_EQ(each.pixel.x(), std::round(each.pixel.x()));
    EXPECT_LT((each.pixel - trueOf(each) - shift).norm(), 0.01);
  }
}

}  // namespace
}  // namespace primitect::moved_list_test
