// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Narrow ends of cones: where the rule puts them, and on simulated frames.
#include "core/cone_tip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "primitect/detector.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::cone_tip_test {
namespace {

using test::kDegree;

/// Of a cone from this distance from its apex on (m, along the axis) to 0.2 m.
Extent extentFrom(const Cone& cone, double begin) {
  constexpr double kEnd = 0.2;
  Extent extent;
  extent.origin = cone.apex + 0.5 * (begin + kEnd) * cone.axis;
  extent.size.z() = kEnd - begin;
  extent.radius = kEnd * std::tan(cone.half_angle);
  extent.radius_small = begin * std::tan(cone.half_angle);
  return extent;
}

TEST(EndAtTip, MovesANarrowEndToTheApex) {
  const Cone cone = {Vec3(0.1, -0.2, 0.8), Vec3(0.6, 0.8, 0.0), 20.0 * kDegree};
  Extent extent = extentFrom(cone, 0.004);
  endAtTip(0.0015, cone, extent);
  EXPECT_EQ(extent.radius_small, 0.0);
  EXPECT_NEAR(extent.size.z(), 0.2, 1e-9);
  EXPECT_LT((extent.origin - (cone.apex + 0.1 * cone.axis)).norm(), 1e-9);
  EXPECT_NEAR(extent.radius, 0.2 * std::tan(cone.half_angle), 1e-9);
}

TEST(EndAtTip, LeavesATopThatCanBeSeenAndOtherKinds) {
  const Cone cone = {Vec3(0.1, -0.2, 0.8), Vec3(0.6, 0.8, 0.0), 20.0 * kDegree};
  Extent stump = extentFrom(cone, 0.005);
  endAtTip(0.0015, cone, stump);
  EXPECT_NEAR(stump.size.z(), 0.195, 1e-9);
  Extent tube;  // whose extent has no narrow end
  tube.size.z() = 0.3;
  endAtTip(0.0015, Cylinder{Vec3::Zero(), Vec3::UnitZ(), 0.05}, tube);
  EXPECT_EQ(tube.size.z(), 0.3);
}

/// Where the cone on a table that the camera sees ends (m above it); it would have its tip at 0.15. top: radius there
/// (m). NaN: there is none.
double topOf(double distance, double top, std::uint64_t seed) {
  constexpr double kHalfAngle = 20.0 * kDegree, kHeight = 0.15;
  const Eigen::Isometry3d table = test::tableBeforeCamera(distance, 35.0 * kDegree);
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table);
  world.add("cone", synthetic::Frustum{kHalfAngle, top / std::tan(kHalfAngle), kHeight},
            table * Eigen::Translation3d(0.0, 0.05, kHeight) * Eigen::AngleAxisd(M_PI, Vec3::UnitX()));
  Detector detector{Params()};
  for (const Detection& item : detector.detect(test::renderedCloud(world, {}, seed)).items) {
    if (kindOf(item.shape) != Kind::cone) continue;
    const Vec3 end = item.extent.origin - 0.5 * item.extent.size.z() * item.extent.rotation.col(2);
    return (table.inverse() * end).z();
  }
  return std::nan("");
}

TEST(ConeTip, IsFoundToSomeMillimeters) {
  std::vector<double> errors;
  for (const double distance : {0.5, 0.8, 1.1}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) errors.push_back(std::abs(topOf(distance, 0.0, seed) - 0.15));
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.0045) << "by the number of points alone 7.5 mm";
}

TEST(ConeTip, IsNotPutOnAStump) {
  constexpr double kTop = 0.006;
  const double height = 0.15 - kTop / std::tan(20.0 * kDegree);
  for (const double distance : {0.5, 0.8, 1.1}) {
    for (const std::uint64_t seed : {1, 2, 3}) EXPECT_NEAR(topOf(distance, kTop, seed), height, 0.005) << distance;
  }
}

}  // namespace
}  // namespace primitect::cone_tip_test
