// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Walls that stray from their plane by more than the noise tells, and what is none for it.
#include "core/uneven_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/choice.h"
#include "core/evidence.h"
#include "primitect/detector.h"
#include "test/support/hypotheses.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"
#include "test/support/uneven_wall.h"

namespace primitect::uneven_planes_test {
namespace {

/// Samples of which a wall is unexplained, and a plane before them is not.
struct Scene {
  Plane known = {Vec3(0.0, 0.5, 0.9), -Vec3::UnitY()};
  int known_count = 600;
  double waves = 0.004;      ///< m, how high those of the wall are
  int count = 400;           ///< samples of the wall
  double half_height = 0.2;  ///< m, of the wall; half of its width is .3 m
  int strays = 0;            ///< more samples, .65 m below its middle
  double bent = 0.0;         ///< 1 / m: the wall is a part of a tube across the line of sight
  double keys = 0.0;         ///< share of its samples that lie 3.4 cm nearer
  bool explained = false;    ///< the wall, too
  NoiseModel noise;
  Params params;

  Scene() {
    noise.depth_share = 1e-3;
    noise.angle = 0.12;
  }

  std::vector<UnevenPlane> found() const {
    constexpr float kWell = 0.9f;
    Random random(91);
    std::vector<test::SurfacePoint> points = test::patchOf(known, known_count, 0.2, random);
    for (int k = 0; k < count + strays; ++k) {
      const double turn = 2.0 * M_PI / 0.15, u = random.uniform(-0.3, 0.3);
      const double v = k < count ? random.uniform(-half_height, half_height) : random.uniform(0.6, 0.7);
      const double key = random.uniform(0.0, 1.0) < keys ? 0.034 : 0.0;
      const double z = test::kUnevenWall - key + waves * std::sin(turn * u) * std::sin(turn * v) + 0.5 * bent * u * u;
      const double along_u = turn * waves * std::cos(turn * u) * std::sin(turn * v) + bent * u;
      const double along_v = turn * waves * std::sin(turn * u) * std::cos(turn * v);
      points.push_back({Vec3(u, v, z), Vec3(along_u, along_v, -1.0).normalized()});
    }
    const Samples samples = test::samplesWith(noise, points);
    SampleGraph graph;
    graph.build(samples);
    HeldGains held(samples.size(), explained ? kWell : 0.0f);
    List<std::uint32_t> owner(samples.size(), explained ? 0 : kNobody);
    std::fill_n(held.begin(), known_count, kWell);
    std::fill_n(owner.begin(), known_count, 0);
    const ProposalRules rules = {noise, {params, 1.0}, 1.0, 0.3};
    const List<UnevenPlane> planes = findUnevenPlanes(samples, graph, held, owner, rules);
    return {planes.begin(), planes.end()};
  }
};

TEST(UnevenPlanes, AreLargeWallsWithWaves) {
  const Scene scene;
  const std::vector<UnevenPlane> planes = scene.found();
  ASSERT_EQ(planes.size(), 1u);
  const Plane wall = planes[0].shape;
  EXPECT_LT(test::lineAngle(wall.normal, Vec3::UnitZ()), 1.0 * test::kDegree);
  EXPECT_NEAR(distance(wall, Vec3(0.0, 0.0, test::kUnevenWall)), 0.0, 0.002);
  EXPECT_GT(planes[0].inliers.size(), 340u);
  EXPECT_GE(planes[0].inliers.front(), 600u) << "what is explained stays where it is";
  EXPECT_TRUE(std::is_sorted(planes[0].inliers.begin(), planes[0].inliers.end()));
  EXPECT_GT(confidenceOf(Kind::plane, planes[0].evidence), 0.9);
}

TEST(UnevenPlanes, AreNotWhatIsExplained) {
  Scene scene;
  scene.explained = true;
  EXPECT_TRUE(scene.found().empty());
}

TEST(UnevenPlanes, TakeNothingFromOthers) {
  Scene scene;
  scene.known = {Vec3(0.8, 0.0, test::kUnevenWall), -Vec3::UnitZ()};
  const std::vector<UnevenPlane> planes = scene.found();
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_GE(planes[0].inliers.front(), 600u);
}

TEST(UnevenPlanes, AreNotSmall) {
  Scene scene;
  scene.known_count = 3000;
  scene.count = 140;  // 4.46 % of all
  EXPECT_TRUE(scene.found().empty());
  scene.count = 180;
  EXPECT_EQ(scene.found().size(), 1u);
  scene.known_count = 0;
  scene.count = 95;
  EXPECT_TRUE(scene.found().empty());
}

TEST(UnevenPlanes, AreNotLookedForWhereAllSamplesAreNoisy) {
  Scene normals, depths;
  normals.noise.angle = 0.31;
  depths.noise.scale = 1.51;
  EXPECT_TRUE(normals.found().empty());
  EXPECT_TRUE(depths.found().empty());
  normals.noise.angle = 0.29;
  depths.noise.scale = 1.49;
  EXPECT_EQ(normals.found().size(), 1u);
  EXPECT_EQ(depths.found().size(), 1u);
}

TEST(UnevenPlanes, HaveAsManySamplesAsAnyShapeNeeds) {
  Scene scene;
  scene.params.min_inliers = 420;
  EXPECT_TRUE(scene.found().empty());
  scene.params.min_inliers = 350;
  EXPECT_EQ(scene.found().size(), 1u);
}

TEST(UnevenPlanes, AreNotNarrow) {
  Scene scene;
  scene.half_height = 0.09;
  EXPECT_TRUE(scene.found().empty());
  scene.strays = 20;
  EXPECT_TRUE(scene.found().empty()) << "what lies elsewhere in its plane makes it no wider";
  scene.strays = 0;
  scene.half_height = 0.13;
  EXPECT_EQ(scene.found().size(), 1u);
}

TEST(UnevenPlanes, AreNotBent) {
  Scene scene;
  scene.bent = 2.0;
  EXPECT_TRUE(scene.found().empty());
}

TEST(UnevenPlanes, AreNotWhatMuchSpeaksAgainst) {
  Scene scene;
  scene.keys = 0.15;
  EXPECT_TRUE(scene.found().empty());
}

TEST(UnevenPlanes, MayBeSpokenAgainstByAsMuchOfAllThatThereIs) {
  Scene scene;
  scene.keys = 0.1;
  EXPECT_TRUE(scene.found().empty());
  scene.known_count = 0;
  const std::vector<UnevenPlane> planes = scene.found();
  ASSERT_FALSE(planes.empty());
  EXPECT_GT(planes[0].inliers.size(), 300u);
}

TEST(UnevenPlanes, AreNotPartsOfWhatIsKnown) {
  Scene scene;
  scene.count = 110;
  EXPECT_EQ(scene.found().size(), 1u);
  scene.known = {Vec3(0.5, 0.0, test::kUnevenWall), -Vec3::UnitZ()};
  EXPECT_TRUE(scene.found().empty());
}

TEST(UnevenPlanes, AreNotFolded) {
  Scene scene;
  scene.waves = 0.015;
  EXPECT_TRUE(scene.found().empty());
}

/// In how many of four images the wall is found.
int wallsFound(double waves, const Params& params = {}) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Detector detector{params};
    const Detections& found = detector.detect(test::renderedCloud(test::tableAndUnevenWall(waves), {}, seed));
    count += std::any_of(found.items.begin(), found.items.end(), [](const Detection& item) {
      const Plane* plane = std::get_if<Plane>(&item.shape);
      return plane && test::lineAngle(plane->normal, Vec3::UnitZ()) < 3.0 * test::kDegree &&
             std::abs(distance(*plane, Vec3(0.0, 0.0, test::kUnevenWall))) < 0.02;
    });
  }
  return count;
}

TEST(UnevenPlanes, AreFoundInFrames) {
  EXPECT_EQ(wallsFound(0.006), 4);
  Params without;
  without.left_out.add(Step::uneven_planes);
  EXPECT_EQ(wallsFound(0.006, without), 0) << "the noise is that of the table";
  EXPECT_EQ(wallsFound(0.01), 0) << "nearly as steep as a cloth";
}

}  // namespace
}  // namespace primitect::uneven_planes_test
