// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cans that lie in a line on a table, and a pipe behind a post.
#include "core/tube_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "primitect/detector.h"
#include "synthetic/sensors.h"
#include "test/support/rendered_cloud.h"

namespace primitect::tube_gaps_test {
namespace {

constexpr double kRadius = 0.033, kHalf = 0.06;  // m, of each can

Eigen::Isometry3d table() { return test::tableBeforeCamera(0.8, 40.0 * M_PI / 180.0); }

synthetic::World tableAlone() {
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table());
  return world;
}

/// Lies along x, its axis a can's radius above the table.
void addRod(double middle, double half, synthetic::World& world, double radius = kRadius) {
  world.add("rod", synthetic::Rod{radius, half},
            table() * Eigen::Translation3d(middle, 0.0, kRadius) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY()));
}

synthetic::World cansInALine(int count, double gap) {
  synthetic::World world = tableAlone();
  const double step = 2.0 * kHalf + gap;
  for (int k = 0; k < count; ++k) addRod((k - 0.5 * (count - 1)) * step, kHalf, world);
  return world;
}

/// Those that are found, with their lengths (m).
std::vector<double> lengthsOfTubes(const synthetic::World& world, std::uint64_t seed,
                                   const synthetic::FrameParams& params = {}) {
  Detector detector{Params()};
  std::vector<double> lengths;
  for (const Detection& item : detector.detect(test::renderedCloud(world, params, seed)).items) {
    if (kindOf(item.shape) == Kind::cylinder) lengths.push_back(item.extent.size.z());
  }
  return lengths;
}

/// In how many of five frames each of the cans is found with its length.
int framesWithEach(int count, double gap, const synthetic::FrameParams& params = {}) {
  int right = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<double> lengths = lengthsOfTubes(cansInALine(count, gap), seed, params);
    const auto isOne = [](double length) { return std::abs(length - 2.0 * kHalf) < 0.01; };
    const bool all = std::all_of(lengths.begin(), lengths.end(), isOne);
    right += all && static_cast<int>(lengths.size()) == count ? 1 : 0;
  }
  return right;
}

TEST(TubeGaps, CansInALineAreADetectionEach) {
  for (const auto& [count, gap] :
       {std::pair(2, 0.01), std::pair(2, 0.04), std::pair(2, 0.1), std::pair(2, 0.2), std::pair(3, 0.05)}) {
    EXPECT_GE(framesWithEach(count, gap), 4) << count << " with gaps of " << gap << " m";
  }
}

TEST(TubeGaps, OfAStereoCameraWhichFillsThemAtTheirEdgesAreWider) {
  synthetic::FrameParams stereo;
  stereo.noise = synthetic::noiseOf("stereo");
  EXPECT_GE(framesWithEach(2, 0.016, stereo), 4);
}

/// Two cans of 12 cm, 8 cm apart, one above the other in free air; a wall far behind them.
TEST(TubeGaps, CansOneAboveTheOtherAreTwoWhereWhatIsBehindIsOutOfRange) {
  synthetic::World world;
  for (const double y : {-0.1, 0.1}) {
    world.add("can", synthetic::Rod{kRadius, kHalf},
              Eigen::Translation3d(0.0, y, 0.8) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitX()));
  }
  std::vector<double> lengths;
  Detector detector{Params()};
  for (const Detection& item : detector.detect(test::cloudBeforeFarWall(world, 1)).items) {
    if (kindOf(item.shape) == Kind::cylinder) lengths.push_back(item.extent.size.z());
  }
  ASSERT_EQ(lengths.size(), 2u);
  for (const double length : lengths) EXPECT_NEAR(length, 2.0 * kHalf, 0.01);
}

TEST(TubeGaps, APipeGoesOnBehindAPost) {
  synthetic::World world = tableAlone();
  addRod(0.0, 0.25, world);
  world.add("post", synthetic::Box{0.03, 0.02, 0.1}, table() * Eigen::Translation3d(0.0, -0.12, 0.1));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<double> lengths = lengthsOfTubes(world, seed);
    ASSERT_EQ(lengths.size(), 1u) << seed;
    EXPECT_NEAR(lengths[0], 0.5, 0.02) << seed;
  }
}

/// What partsOfTube() makes of a tube over what lies in the line; nothing is measured this far (m) around its middle.
List<AxisPart> partsOver(const synthetic::World& world, double half, double missing = 0.0) {
  Cloud cloud = test::renderedCloud(world, synthetic::FrameParams(), 1);
  Detection tube;
  const Eigen::Isometry3d pose = table();
  const Vec3 middle = pose * Vec3(0, 0, kRadius);
  tube.shape = Cylinder{middle, pose.linear().col(0), kRadius};
  tube.extent.origin = middle;
  tube.extent.rotation << pose.linear().col(1), pose.linear().col(2), pose.linear().col(0);
  tube.extent.size.z() = 2.0 * half;
  tube.extent.radius = kRadius;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i) && std::abs(heightOn(tube, cloud, i)) < missing) cloud.setPoint(i, nan, nan, nan, {});
  }
  const PointNoise sigma([](const Vec3& p) { return axialNoise(p.z()); });
  List<std::uint32_t> pixels;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const Vec3 point = cloud.point(i);
    const bool on = cloud.valid(i) && std::abs(distance(tube.shape, point)) < 3.0 * sigma(point);
    const bool above = (pose.inverse() * point).z() > 0.01;
    if (on && above && std::abs(heightOn(tube, cloud, i)) < half) pixels.push_back(i);
  }
  return partsOfTube(tube, pixels, {cloud, findRays(cloud), {0.1f, 2.0f}, sigma});
}

TEST(TubeGaps, AreLengthsThatShowWhatLiesBehind) {
  const List<AxisPart> parts = partsOver(cansInALine(2, 0.08), 0.16);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0].low, -0.16, 0.005);
  EXPECT_NEAR(parts[0].high, -0.04, 0.008);
  EXPECT_NEAR(parts[1].low, 0.04, 0.008);
  EXPECT_NEAR(parts[1].high, 0.16, 0.005);
  EXPECT_EQ(partsOver(cansInALine(1, 0.0), kHalf).size(), 1u);
}

TEST(TubeGaps, AreNoneWhereSomethingIsAroundAPipeOrNothingWasMeasured) {
  synthetic::World world = tableAlone();
  addRod(0.0, 0.2, world);
  EXPECT_EQ(partsOver(world, 0.2, 0.03).size(), 1u) << "a black band";
  addRod(0.0, 0.03, world, kRadius + 0.015);
  EXPECT_EQ(partsOver(world, 0.2).size(), 1u) << "a sleeve";
}

TEST(TubeGaps, AreNoneWithoutPoints) {
  const PointNoise sigma([](const Vec3&) { return 0.001; });
  Detection tube;
  tube.shape = Cylinder{Vec3::UnitZ(), Vec3::UnitX(), kRadius};
  EXPECT_TRUE(partsOfTube(tube, {}, {Cloud(), {}, {}, sigma}).empty());
}

}  // namespace
}  // namespace primitect::tube_gaps_test
