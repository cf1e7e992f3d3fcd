// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cans of which a box hides more than half of the width.
#include <gtest/gtest.h>

#include "primitect/detector.h"
#include "test/support/found_cans.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::half_hidden_test {
namespace {

constexpr double kRadius = 0.04, kHeight = 0.11;  // m

/// A can on a table .6 m away, and before it a tall box that hides all left of this place (radii from the axis).
bool findsCan(double edge, std::uint64_t seed) {
  const Eigen::Isometry3d table = test::tableBeforeCamera(0.6, 37.0 * test::kDegree);
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table);
  const Eigen::Isometry3d middle = table * Eigen::Translation3d(0.0, 0.0, 0.5 * kHeight);
  world.add("can", synthetic::Rod{kRadius, 0.5 * kHeight}, middle);
  world.add("box", synthetic::Box{0.2, 0.01, 0.1},
            table * Eigen::Translation3d(edge * kRadius - 0.2, -kRadius - 0.03, 0.1));
  Detector detector{Params()};
  return test::isCanFound(middle.translation(), kRadius, detector.detect(test::renderedCloud(world, {}, seed)));
}

int found(double edge) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) count += findsCan(edge, seed) ? 1 : 0;
  return count;
}

TEST(HalfHidden, CansAreFoundByLessThanHalfOfTheirWidth) {
  EXPECT_EQ(found(0.0), 12);
  EXPECT_GE(found(0.1), 10) << "none where curved patches must turn by 49 deg and rise 1.5 deviations";
}

}  // namespace
}  // namespace primitect::half_hidden_test
