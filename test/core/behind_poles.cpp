// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cans with something thin and upright before their middle, as a pole or a finger of a gripper.
#include <gtest/gtest.h>

#include <cstdint>

#include "primitect/detector.h"
#include "test/support/found_cans.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::behind_poles_test {
namespace {

constexpr double kHeight = 0.15;  // m

/// A can on a table .9 m away, and 10 cm before its axis a square pole of that width (m).
bool findsCan(double radius, double width, std::uint64_t seed) {
  const Eigen::Isometry3d table = test::tableBeforeCamera(0.9, 37.0 * test::kDegree);
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table);
  const Eigen::Isometry3d middle = table * Eigen::Translation3d(0.0, 0.0, 0.5 * kHeight);
  world.add("can", synthetic::Rod{radius, 0.5 * kHeight}, middle);
  world.add("pole", synthetic::Box{0.5 * width, 0.5 * width, 0.15}, table * Eigen::Translation3d(0.0, -0.1, 0.15));
  Detector detector{Params()};
  return test::isCanFound(middle.translation(), radius, detector.detect(test::renderedCloud(world, {}, seed)));
}

int found(double radius, double width) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) count += findsCan(radius, width, seed) ? 1 : 0;
  return count;
}

TEST(BehindPoles, CansAreOneThing) {
  EXPECT_EQ(found(0.04, 0.006), 8);
  EXPECT_GE(found(0.04, 0.012), 6) << "none where only what is one piece is looked at";
  EXPECT_GE(found(0.033, 0.012), 6);
  EXPECT_GE(found(0.05, 0.02), 4) << "none where normals are judged at their points";
}

}  // namespace
}  // namespace primitect::behind_poles_test
