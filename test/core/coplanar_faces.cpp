// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces of several things that lie in one plane: each is a detection of its own, but what something hides stays one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "primitect/detector.h"
#include "synthetic/scene_layout.h"
#include "test/support/rendered_cloud.h"

namespace primitect::coplanar_faces_test {
namespace {

constexpr double kHeight = 0.08;  // m, of the boxes
constexpr double kAway = 0.9;     // m, the camera

Eigen::Isometry3d at(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Vec3(x, y, z);
  return pose;
}

/// From above at 45 deg, so far away (m).
Eigen::Isometry3d viewFrom(double side, double distance) {
  const Vec3 eye = distance * Vec3(0.7 * std::sin(side), -0.7 * std::cos(side), 0.714);
  return synthetic::lookAt(eye, Vec3::Zero());
}

/// A table, x to the right, y away from the camera, z up, with what stands on it.
struct Table {
  Table() { world.add("table", synthetic::Box{0.6, 0.4, 0.01}, at(0.0, 0.0, -0.01)); }

  /// Of `length` along x, 0.1 m deep.
  void addBox(double x, double y, double length, double height = kHeight) {
    world.add("box", synthetic::Box{0.5 * length, 0.05, 0.5 * height}, at(x, y, 0.5 * height));
  }

  /// What one frame of a camera with noise shows of it, in the table's frame: planes that lie as this one does.
  std::vector<Detection> planesIn(const Plane& plane, int seed, double side = 0.0, double waves = 0.0) const {
    constexpr double kTilt = 0.06, kNear = 0.004;  // rad, m
    const Eigen::Isometry3d pose = viewFrom(side, away);
    Params params;
    params.seed = seed;
    Detector detector{params};
    std::vector<Detection> planes;
    Cloud cloud = test::renderedCloud(world, {}, seed, pose);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto longer = static_cast<float>(1.0 + waves * std::sin(30.0 * 2.0 * M_PI * cloud.x[i]));
      cloud.x[i] *= longer, cloud.y[i] *= longer, cloud.z[i] *= longer;
    }
    for (const Detection& item : detector.detect(cloud).items) {
      const Plane* found = std::get_if<Plane>(&item.shape);
      if (!found || (pose.linear() * found->normal).cross(plane.normal).norm() > kTilt) continue;
      if (std::abs(distance(plane, pose * item.extent.origin)) > kNear) continue;
      planes.push_back(item);
      planes.back().extent.origin = pose * item.extent.origin;
    }
    std::sort(planes.begin(), planes.end(),
              [](const Detection& a, const Detection& b) { return a.extent.origin.x() < b.extent.origin.x(); });
    return planes;
  }

  synthetic::World world;
  double away = kAway;  ///< m, the camera
};

const Plane kTops = {Vec3(0, 0, kHeight), Vec3::UnitZ()};

TEST(CoplanarFaces, OfTwoBoxesOfOneHeightAreOneDetectionEach) {
  for (const double gap : {0.04, 0.1, 0.25}) {
    for (const double side : {-0.4, 0.0, 0.4}) {
      for (int seed = 1; seed <= 3; ++seed) {
        Table table;
        const double x = 0.5 * (gap + 0.14);
        table.addBox(-x, 0.0, 0.14);
        table.addBox(x, 0.0, 0.14);
        const std::vector<Detection> tops = table.planesIn(kTops, seed, side);
        ASSERT_EQ(tops.size(), 2u) << gap << " m, from " << side << ", seed " << seed;
        for (const std::size_t k : {0, 1}) {
          EXPECT_NEAR(tops[k].extent.origin.x(), k == 0 ? -x : x, 0.004);
          EXPECT_NEAR(tops[k].extent.size.x(), 0.14, 0.01);
          EXPECT_NEAR(tops[k].extent.size.y(), 0.1, 0.01);
        }
      }
    }
  }
}

TEST(CoplanarFaces, LeaveOutWhatIsTooSmallForAPlaneOfItsOwn) {
  for (int seed = 1; seed <= 5; ++seed) {
    Table table;
    table.away = 1.4;  // of the small one some 350 pixels are seen
    table.addBox(-0.1, 0.0, 0.16);
    table.addBox(0.2, 0.0, 0.036);
    const std::vector<Detection> tops = table.planesIn(kTops, seed);
    ASSERT_EQ(tops.size(), 1u) << "seed " << seed;
    EXPECT_NEAR(tops[0].extent.origin.x(), -0.1, 0.006);
    EXPECT_NEAR(tops[0].extent.size.x(), 0.16, 0.015) << "not .34, to the end of the other one";
  }
}

TEST(CoplanarFaces, ShareTheEvidence) {
  for (int seed = 1; seed <= 5; ++seed) {
    Table table;
    table.addBox(-0.15, 0.0, 0.2);
    table.addBox(0.1, 0.0, 0.1);
    const std::vector<Detection> tops = table.planesIn(kTops, seed);
    ASSERT_EQ(tops.size(), 2u) << "seed " << seed;
    EXPECT_NEAR(tops[0].evidence.inliers / tops[1].evidence.inliers, 2.0, 0.5);
    EXPECT_GT(tops[0].confidence, tops[1].confidence) << "of twice as many samples";
  }
}

TEST(CoplanarFaces, OfTwoFrontsOnATableAreOneDetectionEach) {
  const Plane fronts = {Vec3(0, -0.05, 0), -Vec3::UnitY()};
  for (int seed = 1; seed <= 3; ++seed) {
    Table table;
    table.addBox(-0.14, 0.0, 0.16, 0.12);
    table.addBox(0.14, 0.0, 0.16, 0.15);
    const std::vector<Detection> found = table.planesIn(fronts, seed);
    ASSERT_EQ(found.size(), 2u) << "seed " << seed;
    for (const std::size_t k : {0, 1}) EXPECT_NEAR(found[k].extent.origin.x(), k == 0 ? -0.14 : 0.14, 0.006);
  }
}

TEST(CoplanarFaces, OfFrontsAreApartAlongTheTableTheyStandOn) {
  // Of boxes 5 cm high, as high as the foot in which the table is not clearly behind is twice.
  const Plane fronts = {Vec3(0, -0.05, 0), -Vec3::UnitY()};
  for (int seed = 1; seed <= 5; ++seed) {
    Table table;
    for (const int k : {-1, 0, 1}) table.addBox(0.13 * k, 0.0, 0.08, 0.05);
    const std::vector<Detection> found = table.planesIn(fronts, seed);
    EXPECT_EQ(found.size(), 3u) << "seed " << seed;
    for (const Detection& front : found) EXPECT_LT(front.extent.size.x(), 0.1) << "seed " << seed;
  }
}

TEST(CoplanarFaces, OfATableAreOneBehindAWideBox) {
  const Plane level = {Vec3::Zero(), Vec3::UnitZ()};
  for (int seed = 1; seed <= 3; ++seed) {
    Table table;
    table.addBox(0.0, 0.0, 1.3);
    EXPECT_EQ(table.planesIn(level, seed).size(), 1u) << "seed " << seed;
  }
}

TEST(CoplanarFaces, AreOneWhereACanHidesTheMiddle) {
  for (int seed = 1; seed <= 3; ++seed) {
    Table table;
    table.addBox(0.0, 0.1, 0.4);
    table.world.add("can", synthetic::Rod{0.04, 0.12}, at(0.0, -0.1, 0.12));
    const std::vector<Detection> tops = table.planesIn(kTops, seed);
    ASSERT_EQ(tops.size(), 1u) << "seed " << seed;
    EXPECT_NEAR(tops[0].extent.origin.x(), 0.0, 0.01);
    EXPECT_NEAR(tops[0].extent.size.x(), 0.4, 0.015);
  }
}

/// One of two level lids is above a can of which too little is seen to be one: the first pixels of its side, which
/// nothing explains, count for the lid.
TEST(CoplanarFaces, MayHaveASideThatNothingExplains) {
  constexpr double kCan = 0.144, kTaller = 0.156, kRadius = 0.037;  // m
  constexpr int kSeeds = 8;
  const Plane lids = {Vec3(0, 0, kCan), Vec3::UnitZ()};
  int found = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Table table;
    table.world.add("can", synthetic::Rod{kRadius, 0.5 * kCan}, at(-0.13, 0.0, 0.5 * kCan));
    table.world.add("before", synthetic::Rod{kRadius, 0.5 * kTaller}, at(0.0, 0.0, 0.5 * kTaller));
    table.world.add("behind", synthetic::Rod{kRadius, 0.5 * kCan}, at(0.006, 0.1, 0.5 * kCan));
    found += static_cast<int>(table.planesIn(lids, seed).size());
  }
  EXPECT_GE(found, 2 * kSeeds - 2);  // of the one behind 700 pixels are seen: not every draw has enough of them
}

/// Nothing is seen of what lies between them.
TEST(CoplanarFaces, AreApartWhereTheyAreFarFromEachOtherForTheirSize) {
  constexpr double kCan = 0.12, kRadius = 0.035, kApart = 0.48;  // m
  const Plane lids = {Vec3(0, 0, kCan), Vec3::UnitZ()};
  for (int seed = 1; seed <= 6; ++seed) {
    Table table;
    for (const double x : {-0.5 * kApart, 0.5 * kApart}) {
      table.world.add("can", synthetic::Rod{kRadius, 0.5 * kCan}, at(x, 0.05, 0.5 * kCan));
    }
    table.addBox(0.0, 0.0, 0.4, 0.24);
    const std::vector<Detection> found = table.planesIn(lids, seed);
    ASSERT_EQ(found.size(), 2u) << "seed " << seed;
    for (const std::size_t k : {0, 1}) {
      EXPECT_NEAR(found[k].extent.size.x(), 2.0 * kRadius, 0.006);
      EXPECT_GT(found[k].coverage, 0.9f);
    }
  }
}

/// As wide a gap as before, between the ends of a board.
TEST(CoplanarFaces, AreOneWhereTheyAreLongForTheGap) {
  for (int seed = 1; seed <= 3; ++seed) {
    Table table;
    table.world.add("board", synthetic::Box{0.45, 0.05, 0.06}, at(0.0, 0.05, 0.06));
    table.addBox(0.0, -0.06, 0.3, 0.24);  // of the board it hides 0.4 m
    const std::vector<Detection> found = table.planesIn({Vec3(0, 0, 0.12), Vec3::UnitZ()}, seed);
    ASSERT_EQ(found.size(), 1u) << "seed " << seed;
    EXPECT_GT(found[0].extent.size.x(), 0.85);
  }
}

TEST(CoplanarFaces, MayAllHaveTheWavesOfTheCamera) {
  constexpr double kWaves = 0.0035;  // of the depth: 1.7 standard deviations of its noise
  for (int seed = 1; seed <= 3; ++seed) {
    Table table;
    table.addBox(-0.15, 0.0, 0.2);
    table.addBox(0.15, 0.0, 0.14);
    EXPECT_EQ(table.planesIn(kTops, seed, 0.0, kWaves).size(), 2u) << "seed " << seed;
  }
}

TEST(CoplanarFaces, MayBeNarrow) {
  constexpr int kSlats = 9;
  constexpr double kWidth = 0.015, kLength = 0.3, kEvery = 0.04;  // m: some nine pixels wide, as far as they are narrow
  for (int seed = 1; seed <= 3; ++seed) {
    Table table;
    for (int k = 0; k < kSlats; ++k) {
      const double x = kEvery * (k - kSlats / 2);
      table.world.add("slat", synthetic::Box{0.5 * kWidth, 0.5 * kLength, 0.5 * kHeight}, at(x, 0.0, 0.5 * kHeight));
    }
    const std::vector<Detection> tops = table.planesIn(kTops, seed);
    ASSERT_EQ(tops.size(), static_cast<std::size_t>(kSlats)) << "seed " << seed;
    for (int k = 0; k < kSlats; ++k) {
      EXPECT_NEAR(tops[k].extent.origin.x(), kEvery * (k - kSlats / 2), 0.003);
      EXPECT_NEAR(tops[k].extent.size.x(), kLength, 0.01);
    }
  }
}

TEST(CoplanarFaces, AreLookedForInSmallerCells) {
  // Slats of nine pixels, so far apart that the cells for all of them are too large: in five of six frames some would be
  // one plane.
  constexpr int kSlats = 9;
  constexpr double kWidth = 0.015, kEvery = 0.045;  // m
  for (int seed = 1; seed <= 6; ++seed) {
    Table table;
    for (int k = 0; k < kSlats; ++k) {
      table.world.add("slat", synthetic::Box{0.5 * kWidth, 0.15, 0.5 * kHeight},
                      at(kEvery * (k - kSlats / 2), 0.0, 0.5 * kHeight));
    }
    const std::vector<Detection> tops = table.planesIn(kTops, seed);
    ASSERT_EQ(tops.size(), static_cast<std::size_t>(kSlats)) << "seed " << seed;
    for (int k = 0; k < kSlats; ++k) EXPECT_NEAR(tops[k].extent.origin.x(), kEvery * (k - kSlats / 2), 0.003);
  }
}

/// In free air, with nothing behind within the range.
TEST(CoplanarFaces, AreApartWhereWhatLiesBetweenWasCutAway) {
  synthetic::World world;
  for (const double x : {-0.15, 0.15}) world.add("board", synthetic::Sheet{0.1, 0.15}, at(x, 0.0, 0.9));
  Detector detector{Params()};
  const std::vector<Detection>& boards = detector.detect(test::cloudBeforeFarWall(world, 1)).items;
  ASSERT_EQ(boards.size(), 2u);
  for (const Detection& board : boards) {
    EXPECT_EQ(kindOf(board.shape), Kind::plane);
    EXPECT_NEAR(board.extent.size.x(), 0.3, 0.01);
    EXPECT_NEAR(board.extent.size.y(), 0.2, 0.01);
  }
}

/// A wall that comes near the bound: of its waves half are cut away.
TEST(CoplanarFaces, AreNoneWhereTheCameraTakesPointsBeyondTheRange) {
  synthetic::World world;
  world.add("wall", synthetic::Sheet{0.4, 0.3}, at(0.0, 0.0, 1.998));
  synthetic::FrameParams params;
  params.truth.range.max = 3.0f;
  params.noise.scale = 0.2;
  const Cloud all = test::renderedCloud(world, params, 1);
  Cloud cut;
  cut.reset(all.width, all.height, false);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto longer = static_cast<float>(1.0 + 0.004 * std::sin(10.0 * 2.0 * M_PI * all.x[i]));
    cut.setPoint(i, longer * all.x[i], longer * all.y[i], longer * all.z[i], {0.1f, 2.0f});
  }
  Detector detector{Params()};
  const std::vector<Detection>& walls = detector.detect(cut).items;
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_NEAR(walls[0].extent.size.x(), 0.8, 0.06);
}

constexpr double kThick = 0.05;  // m
Table lyingTube() {
  Table table;
  table.world.add("tube", synthetic::Rod{0.5 * kThick, 0.1},
                  at(0.118, 0.0, 0.5 * kThick) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitX()));
  return table;
}

/// The same 6 cm beside a can as high as it is thick, whose top has its middle at (0, 0).
Table canAndTube() {
  Table table = lyingTube();
  table.world.add("can", synthetic::Rod{0.033, 0.5 * kThick}, at(0.0, 0.0, 0.5 * kThick));
  return table;
}

/// The top and a strip of the tube were one plane of 19 x 13 cm in half of the frames.
TEST(CoplanarFaces, GiveTheStripOfATubeThatTheyAreLevelWithToTheTube) {
  const Table table = canAndTube();
  for (int seed = 1; seed <= 10; ++seed) {
    const std::vector<Detection> tops = table.planesIn({Vec3(0.0, 0.0, kThick), Vec3::UnitZ()}, seed);
    ASSERT_EQ(tops.size(), 1u) << seed;
    EXPECT_LT(tops[0].extent.origin.head<2>().norm(), 0.008) << seed;
    EXPECT_LT(tops[0].extent.size.maxCoeff(), 0.075) << seed;
    EXPECT_GT(tops[0].confidence, 0.9f) << seed;
  }
}

/// The points of a tube in ten frames.
double pointsOfTube(const Table& table) {
  double points = 0.0;
  for (int seed = 1; seed <= 10; ++seed) {
    Detector detector{Params()};
    for (const Detection& item :
         detector.detect(test::renderedCloud(table.world, {}, seed, viewFrom(0.0, kAway))).items) {
      const bool lies = std::abs((viewFrom(0.0, kAway).linear() * item.extent.rotation.col(2)).z()) < 0.1;
      points += kindOf(item.shape) == Kind::cylinder && lies ? item.inlier_count : 0.0;
    }
  }
  return points;
}

TEST(CoplanarFaces, TakeNoPointsOfThatTube) { EXPECT_GT(pointsOfTube(canAndTube()), 0.99 * pointsOfTube(lyingTube())); }

/// A bar 2 mm higher than the tube that it lies on, level with a box beside the tube.
TEST(CoplanarFaces, OnATubeStayFaces) {
  constexpr double kTop = 0.102;
  Table table;
  table.world.add("tube", synthetic::Rod{0.05, 0.15},
                  at(0.0, 0.0, 0.05) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY()));
  table.world.add("bar", synthetic::Box{0.1, 0.02, 0.5 * kTop}, at(0.0, 0.0, 0.5 * kTop));
  table.addBox(0.0, 0.14, 0.1, kTop);
  int bars = 0;
  for (int seed = 1; seed <= 5; ++seed) {
    for (const Detection& top : table.planesIn({Vec3(0.0, 0.0, kTop), Vec3::UnitZ()}, seed)) {
      bars += top.extent.size.maxCoeff() > 0.15 && std::abs(top.extent.origin.y()) < 0.02 ? 1 : 0;
    }
  }
  EXPECT_GE(bars, 2);
}

}  // namespace
}  // namespace primitect::coplanar_faces_test
