// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A detector takes nothing from the heap in frames that are like those it has seen.
#include "eval/bench/allocations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "primitect/detector.h"
#include "synthetic/frame.h"
#include "synthetic/paper_dataset.h"
#include "synthetic/sensors.h"
#include "synthetic/tabletop.h"
#include "test/support/rendered_cloud.h"
#include "test/support/uneven_wall.h"

namespace primitect::allocations_test {
namespace {

/// Cut at the default's depths.
std::vector<Cloud> tabletops(std::uint64_t first_seed, std::size_t count,
                             const synthetic::PinholeCamera& camera = synthetic::PinholeCamera(),
                             const synthetic::FrameParams& frame_params = {}) {
  const Params params;
  const DepthRange range{static_cast<float>(params.min_depth), static_cast<float>(params.max_depth)};
  std::vector<Cloud> clouds(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint64_t seed = first_seed + k;
    const Eigen::Isometry3d pose = synthetic::cameraPose(static_cast<double>(seed));
    const synthetic::Frame frame = renderFrame(synthetic::tabletop(seed), camera, pose, frame_params, seed, 0);
    synthetic::cloudFromDepth(frame.depth, camera, range, clouds[k]);
  }
  return clouds;
}

Params sceneParams() {
  Params params;
  params.min_depth = params.max_depth = 0.0;
  params.orient_normals = false;
  return params;
}

void detectAll(const std::vector<Cloud>& clouds, Detector& detector) {
  for (const Cloud& cloud : clouds) ASSERT_FALSE(detector.detect(cloud).items.empty());
}

std::size_t allocationsOf(const Cloud& cloud, Detector& detector, const Effort& effort = {}) {
  bench::beginCounting();
  detector.detect(cloud, effort);
  return bench::endCounting().count;
}

/// Twice: what is taken first may make room where it is not needed the second time.
void warmUp(const std::vector<Cloud>& clouds, Detector& detector) {
  for (int pass = 0; pass < 2; ++pass) detectAll(clouds, detector);
}

class Allocations : public testing::Test {
 protected:
  void SetUp() override {
    if (!bench::canCountAllocations()) GTEST_SKIP() << "malloc cannot be replaced here";
  }
};

TEST_F(Allocations, AreMadeByANewDetector) {
  const std::vector<Cloud> clouds = tabletops(1, 1);
  Detector detector{Params()};
  EXPECT_GT(allocationsOf(clouds[0], detector), 100u);
}

TEST_F(Allocations, AreNoneInDepthFramesThatWereSeen) {
  const std::vector<Cloud> clouds = tabletops(1, 4);
  Detector detector{Params()};
  warmUp(clouds, detector);
  for (const Cloud& cloud : clouds) EXPECT_EQ(allocationsOf(cloud, detector), 0u);
}

/// Two boxes beside each other, 2 mm apart in height, from above.
Cloud topsOfNearlyOneHeight() {
  const auto at = [](double x, double z) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Vec3(x, 0.0, z);
    return pose;
  };
  synthetic::World world;
  world.add("table", synthetic::Box{0.6, 0.4, 0.01}, at(0.0, -0.01));
  for (const int side : {-1, 1}) {
    const double height = 0.04 + 0.001 * side;
    world.add("box", synthetic::Box{0.05, 0.05, 0.5 * height}, at(0.075 * side, 0.5 * height));
  }
  Eigen::Isometry3d pose(Eigen::AngleAxisd(-0.75 * M_PI, Vec3::UnitX()));
  pose.pretranslate(0.9 * Vec3(0.0, -std::sqrt(0.5), std::sqrt(0.5)));
  return test::renderedCloud(world, synthetic::FrameParams(), 1, pose);
}

TEST_F(Allocations, AreNoneWhereTopsAreTakenApart) {
  const std::vector<Cloud> clouds = {topsOfNearlyOneHeight()};
  Detector detector{Params()};
  warmUp(clouds, detector);
  const auto& items = detector.detect(clouds[0]).items;
  const auto tops = std::count_if(items.begin(), items.end(), [&](const Detection& item) {
    const Plane* plane = std::get_if<Plane>(&item.shape);
    return plane && std::abs(plane->normal.dot(std::get<Plane>(items[0].shape).normal)) > 0.999;
  });
  EXPECT_EQ(tops, 3) << "the table's and two of boxes";
  EXPECT_EQ(allocationsOf(clouds[0], detector), 0u);
}

TEST_F(Allocations, AreNoneWhereLargePlanesAreUneven) {
  const std::vector<Cloud> clouds = {test::renderedCloud(test::tableAndUnevenWall(0.006), {}, 1)};
  Params params;
  params.sensor_frame = "a_frame_with_a_name_that_takes_memory";
  Detector detector{params};
  warmUp(clouds, detector);
  EXPECT_EQ(detector.result().items.size(), 2u) << "the table, and the wall by more noise";
  EXPECT_EQ(allocationsOf(clouds[0], detector), 0u);
}

TEST_F(Allocations, AreNoneWhereTheCameraBendsWhatItSees) {
  synthetic::FrameParams bent;
  bent.noise = synthetic::noiseOf("bent_structured_light");
  const std::vector<Cloud> clouds = tabletops(1, 2, synthetic::PinholeCamera(), bent);
  Detector detector{Params()};
  warmUp(clouds, detector);
  EXPECT_GT(detector.result().depth_waves, 0.0);
  for (const Cloud& cloud : clouds) EXPECT_EQ(allocationsOf(cloud, detector), 0u);
}

TEST_F(Allocations, AreNoneInDepthFramesThatLostTheirOrder) {
  std::vector<Cloud> clouds = tabletops(1, 2);
  for (Cloud& cloud : clouds) cloud.width *= cloud.height, cloud.height = 1;
  Detector detector{Params()};
  warmUp(clouds, detector);
  for (const Cloud& cloud : clouds) EXPECT_EQ(allocationsOf(cloud, detector), 0u);
}

TEST_F(Allocations, AreNoneInLargeCloudsThatWereSeen) {
  std::vector<Cloud> clouds = tabletops(1, 2, synthetic::PinholeCamera().scaledTo(1280, 960));
  Detector detector{Params()};
  warmUp(clouds, detector);
  for (const Cloud& cloud : clouds) EXPECT_EQ(allocationsOf(cloud, detector), 0u);
  // The paper's points three times over.
  Cloud scene = makePaperScene(synthetic::SceneKind::mixed, 1, 0.01).cloud;
  for (auto values : {&Cloud::x, &Cloud::y, &Cloud::z, &Cloud::nx, &Cloud::ny, &Cloud::nz}) {
    const std::vector<float> once = scene.*values;
    for (int copy = 0; copy < 2; ++copy) (scene.*values).insert((scene.*values).end(), once.begin(), once.end());
  }
  scene.width *= 3, scene.valid_count *= 3;
  clouds = {scene};
  Detector without_order(sceneParams());
  warmUp(clouds, without_order);
  EXPECT_EQ(allocationsOf(clouds[0], without_order), 0u);
}

TEST_F(Allocations, AreNoneInDepthFramesOfLessEffort) {
  const std::vector<Cloud> clouds = tabletops(1, 2);
  Detector detector{Params()};
  warmUp(clouds, detector);
  const Effort less = {0.5, [] { return 0.7; }};
  for (const Cloud& cloud : clouds) allocationsOf(cloud, detector, less);
  for (const Cloud& cloud : clouds) EXPECT_EQ(allocationsOf(cloud, detector, less), 0u);
}

/// A frame may hold more than any before it: then something grows, once, and by less than a frame's lists take.
TEST_F(Allocations, AreFewInDepthFramesThatWereNotSeen) {
  Detector detector{Params()};
  warmUp(tabletops(1, 4), detector);
  std::size_t all = 0;
  for (const Cloud& cloud : tabletops(5, 4)) all += allocationsOf(cloud, detector);
  RecordProperty("allocations_in_four_frames", static_cast<int>(all));
  EXPECT_LT(all, 40u);
}

TEST_F(Allocations, AreNoneInCloudsWithNormalsThatWereSeen) {
  constexpr double kNoise = 0.01;  // m
  const std::vector<Cloud> clouds = {makePaperScene(synthetic::SceneKind::mixed, 1, kNoise).cloud};
  Detector detector(sceneParams());
  warmUp(clouds, detector);
  EXPECT_EQ(allocationsOf(clouds[0], detector), 0u);
}

TEST_F(Allocations, AreNoneWhereInsidesAreLookedForToo) {
  const std::vector<Cloud> clouds = tabletops(1, 2);
  Params params;
  params.convexity = "both";
  Detector detector{params};
  warmUp(clouds, detector);
  for (const Cloud& cloud : clouds) EXPECT_EQ(allocationsOf(cloud, detector), 0u);
}

TEST_F(Allocations, AreNoneWhenPointsAreLabelled) {
  const std::vector<Cloud> clouds = tabletops(1, 1);
  Detector detector{Params()};
  warmUp(clouds, detector);
  std::vector<std::uint32_t> labels;
  detector.label(clouds[0], labels);
  bench::beginCounting();
  detector.label(clouds[0], labels);
  EXPECT_EQ(bench::endCounting().count, 0u);
}

}  // namespace
}  // namespace primitect::allocations_test
