// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What keeps a shape from being found is counted under its name.
#include <gtest/gtest.h>

#include <optional>

#include "core/competition.h"
#include "primitect/detector.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::refusals_test {
namespace {

using test::kDegree;

/// max_radius (m), sharpest (deg): of the scene, besides those of the parameters.
std::optional<Refusal> brokenBy(const Shape& shape, double max_radius = 0.4, double sharpest = 8.0) {
  Params params;
  params.min_radius = 0.02;
  params.max_radius = 0.5;
  params.min_half_angle_deg = 4.0;
  params.max_half_angle_deg = 65.0;
  constexpr double kMinDistance = 0.005;
  return Limits{params, max_radius, sharpest, kMinDistance}.brokenBy(shape);
}

TEST(Limits, NameTheOneThatAShapeBreaks) {
  const Vec3 at(0.0, 0.0, 1.0);
  const auto cone = [&at](double half_angle_deg) { return Cone{at, Vec3::UnitY(), half_angle_deg * kDegree}; };
  EXPECT_EQ(brokenBy(Sphere{at, 0.019}), Refusal::too_small);
  EXPECT_EQ(brokenBy(Sphere{at, 0.021}), std::nullopt);
  EXPECT_EQ(brokenBy(Sphere{at, 0.39}), std::nullopt);
  EXPECT_EQ(brokenBy(Sphere{at, 0.41}), Refusal::too_large) << "of the scene";
  EXPECT_EQ(brokenBy(Cylinder{at, Vec3::UnitY(), 0.49}, 1.0), std::nullopt);
  EXPECT_EQ(brokenBy(Cylinder{at, Vec3::UnitY(), 0.51}, 1.0), Refusal::too_large) << "of the parameters";
  EXPECT_EQ(brokenBy(cone(7.0)), Refusal::half_angle);
  EXPECT_EQ(brokenBy(cone(9.0)), std::nullopt);
  EXPECT_EQ(brokenBy(cone(5.0), 1.0, 0.0), std::nullopt);
  EXPECT_EQ(brokenBy(cone(3.0), 1.0, 0.0), Refusal::half_angle) << "of the parameters";
  EXPECT_EQ(brokenBy(cone(66.0)), Refusal::half_angle);
  EXPECT_EQ(brokenBy(Plane{0.004 * at, Vec3::UnitZ()}), Refusal::edge_on);
  EXPECT_EQ(brokenBy(Plane{at, Vec3::UnitZ()}), std::nullopt);
}

/// Of a thing on a table .8 m away: so high (m) above it, turned about x (rad).
Detections detected(const synthetic::Solid& thing, double height, double turn, const Params& params,
                    std::uint64_t seed) {
  const Eigen::Isometry3d table = test::tableBeforeCamera(0.8, 35.0 * kDegree);
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table);
  world.add("thing", thing, table * Eigen::Translation3d(0.0, 0.0, height) * Eigen::AngleAxisd(turn, Vec3::UnitX()));
  Detector detector{params};
  return detector.detect(test::renderedCloud(world, {}, seed));
}

/// With the default the thing is found; with these limits it is not, and this count grows.
void expectCounted(const synthetic::Solid& thing, double height, Kind kind, const Params& limits, Refusal refusal) {
  const Detections with = detected(thing, height, 0.0, limits, 11);
  const Detections without = detected(thing, height, 0.0, Params(), 11);
  EXPECT_TRUE(test::finds(without, kind)) << refusalName(refusal);
  EXPECT_FALSE(test::finds(with, kind)) << refusalName(refusal);
  EXPECT_GT(with.refusals[refusal], without.refusals[refusal]) << refusalName(refusal);
}

TEST(Refusals, CountABallThatIsTooLargeOrTooSmall) {
  const synthetic::Ball ball = {0.08};
  Params params;
  params.max_radius = 0.06;
  expectCounted(ball, 0.08, Kind::sphere, params, Refusal::too_large);
  params = {};
  params.min_radius = 0.1;
  expectCounted(ball, 0.08, Kind::sphere, params, Refusal::too_small);
}

TEST(Refusals, CountAConeThatIsTooFlatOrTooSharp) {
  // Stands on its tip, cut off below.
  const synthetic::Frustum cone = {25.0 * kDegree, 0.06, 0.2};
  Params params;
  params.max_half_angle_deg = 15.0;
  expectCounted(cone, -0.06, Kind::cone, params, Refusal::half_angle);
  params = {};
  params.min_half_angle_deg = 35.0;
  expectCounted(cone, -0.06, Kind::cone, params, Refusal::half_angle);
}

/// Its apex is up: a mound that hardly bends.
TEST(Refusals, CountAMoundThatIsNearlyFlat) {
  const synthetic::Frustum mound = {70.0 * kDegree, 0.0, 0.04};
  std::uint32_t counted = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Detections found = detected(mound, 0.04, M_PI, Params(), seed);
    EXPECT_FALSE(test::finds(found, Kind::cone)) << seed;
    counted += found.refusals[Refusal::half_angle];
  }
  EXPECT_GT(counted, 0u);
}

}  // namespace
}  // namespace primitect::refusals_test
