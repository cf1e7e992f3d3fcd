// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What is left of solids against areas and insides that can be worked out by hand.
#include "synthetic/csg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace primitect::synthetic::csg_test {
namespace {

Placed at(double x, double y, double z, const Solid& solid) {
  return {solid, Eigen::Isometry3d(Eigen::Translation3d(x, y, z))};
}

/// Shares of the samples among surfaces.
std::vector<double> shares(const Csg& part, std::size_t count = 20000) {
  Random random(1);
  std::vector<double> share(part.surfaces().size(), 0.0);
  for (const BoundaryPoint& sample : part.sampleBoundary(count, random)) share[sample.surface] += 1.0 / count;
  return share;
}

// With 20000 samples a share is known to 0.0035 (one standard deviation, at worst).
constexpr double kFour = 4 * 0.0035;

TEST(Csg, SpreadsSamplesByArea) {
  Csg part;
  part.add(at(0, 0, 0, Box{1.0, 0.5, 0.25}));
  const std::vector<double> share = shares(part);
  const double area = 2 * (0.5 + 1.0 + 2.0);
  for (int side = 0; side < 6; ++side) EXPECT_NEAR(share[side], (side < 2 ? 0.5 : side < 4 ? 1.0 : 2.0) / area, kFour);
}

TEST(Csg, SpreadsSamplesByAreaOnRoundFacesToo) {
  Csg rod, cone, ball;
  rod.add({Rod{1.0, 2.0}});
  cone.add({Frustum{std::atan(0.5), 1.0, 4.0}});
  EXPECT_NEAR(shares(rod)[0], 8.0 / 10.0, kFour);
  const double mantle = 0.5 * std::sqrt(1.25) * 15.0, caps = 0.25 * 17.0;
  EXPECT_NEAR(shares(cone)[0], mantle / (mantle + caps), kFour);
  ball.add({Ball{1.0}});
  Random random(2);
  int upper = 0;
  for (const BoundaryPoint& sample : ball.sampleBoundary(20000, random)) upper += sample.point.z() > 0.5;
  EXPECT_NEAR(upper / 20000.0, 0.25, kFour);
}

TEST(Csg, AHoleTakesItsMouthsAwayAndAddsItsWall) {
  Csg part;
  part.add({Box{1.0, 1.0, 0.5}});
  part.cut({Rod{0.5, 1.0}});
  const std::vector<double> share = shares(part);
  const double top = 4.0 - M_PI * 0.25, wall = M_PI, area = 2 * top + 4 * 2.0 + wall;
  EXPECT_NEAR(share[5], top / area, kFour);
  EXPECT_NEAR(share[6], wall / area, kFour);
  EXPECT_EQ(share[7] + share[8], 0.0) << "the ends of the cutter are in the air";
  EXPECT_TRUE(part.surfaces()[6].concave);
  EXPECT_FALSE(part.surfaces()[5].concave);
  EXPECT_TRUE(part.inside({0.8, 0.0, 0.0}));
  EXPECT_FALSE(part.inside({0.3, 0.0, 0.0}));
}

TEST(Csg, CountsFacesThatFallTogetherOnce) {
  Csg part;  // two blocks that overlap by half, with common top, bottom and long sides
  part.add(at(0.0, 0, 0, Box{1.0, 0.5, 0.5}));
  part.add(at(1.0, 0, 0, Box{1.0, 0.5, 0.5}));
  const std::vector<double> share = shares(part);
  const double area = 4 * 3.0 + 2 * 1.0;
  EXPECT_NEAR(share[5], 2.0 / area, kFour);
  EXPECT_NEAR(share[6 + 5], 1.0 / area, kFour);
  EXPECT_NEAR(share[0], 1.0 / area, kFour);
  EXPECT_EQ(share[1], 0.0) << "within the second block";
}

TEST(Csg, NormalsPointOutOfTheMaterial) {
  Csg part;
  part.add({Box{1.0, 1.0, 0.5}});
  part.cut(at(0.0, 0.0, 0.5, Box{0.3, 0.3, 0.2}));
  part.cut(at(0.6, 0.6, 0.5, Ball{0.2}));
  part.add(at(-0.6, 0.0, 0.4, Frustum{0.4, 0.1, 0.7}));
  part.cut(at(0.7, -0.6, 0.0, Rod{0.1, 1.0}));
  Random random(3);
  for (const BoundaryPoint& sample : part.sampleBoundary(5000, random)) {
    EXPECT_NEAR(sample.normal.norm(), 1.0, 1e-12);
    ASSERT_FALSE(part.inside(sample.point + 1e-6 * sample.normal));
    ASSERT_TRUE(part.inside(sample.point - 1e-6 * sample.normal));
    const Surface& surface = part.surfaces()[sample.surface];
    const double side = normalAt(surface.shape, sample.point).dot(sample.normal);
    EXPECT_NEAR(side, surface.concave ? -1.0 : 1.0, 1e-12);
  }
}

TEST(Csg, LaterStepsWin) {
  Csg part;
  part.add({Ball{1.0}});
  part.cut({Ball{0.5}});
  part.add({Ball{0.2}});
  EXPECT_TRUE(part.inside({0.0, 0.0, 0.1}));
  EXPECT_FALSE(part.inside({0.0, 0.0, 0.3}));
  EXPECT_TRUE(part.inside({0.0, 0.0, 0.7}));
  EXPECT_FALSE(part.inside({0.0, 0.0, 1.1}));
}

TEST(Csg, RefusesWhatItCannotSample) {
  Csg part;
  Random random(4);
  EXPECT_THROW(part.add({Torus{0.2, 0.1}}), std::invalid_argument);
  EXPECT_THROW(part.add({Ball{-1.0}}), std::invalid_argument);
  EXPECT_THROW(part.sampleBoundary(10, random), std::runtime_error);
  part.add({Ball{1.0}});
  part.cut({Ball{2.0}});
  EXPECT_THROW(part.sampleBoundary(10, random), std::runtime_error);
}

}  // namespace
}  // namespace primitect::synthetic::csg_test
