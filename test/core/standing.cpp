// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cans and hats on a table and beside it.
#include "core/standing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect::standing_test {
namespace {

using test::kDegree;
using test::SurfacePoint;

/// On the table; the sensor is at the origin, z up.
const Vec3 kMiddle = Vec3(0, 1, -0.3);

/// A table with samples 2 cm apart, and something above its middle, which hides 6 cm around.
struct Scene {
  Samples samples;
  List<std::uint32_t> of_table, of_shape;
  Shape shape;

  Scene(const Shape& thing, const std::vector<SurfacePoint>& seen, double table_reach = 0.3, double hidden = 0.06)
      : shape(thing) {
    constexpr double kSpacing = 0.02;
    std::vector<SurfacePoint> all;
    for (double x = -table_reach; x <= table_reach; x += kSpacing) {
      for (double y = -table_reach; y <= table_reach; y += kSpacing) {
        if (std::hypot(x, y) > hidden) all.push_back({kMiddle + Vec3(x, y, 0.0), Vec3::UnitZ()});
      }
    }
    for (std::uint32_t i = 0; i < all.size(); ++i) of_table.push_back(i);
    for (std::uint32_t i = 0; i < seen.size(); ++i) of_shape.push_back(static_cast<std::uint32_t>(all.size()) + i);
    all.insert(all.end(), seen.begin(), seen.end());
    samples = test::samplesOf(all);
  }
  double stands() const { return standsOn({kMiddle, Vec3::UnitZ()}, of_table, shape, of_shape, samples); }
};

/// From `low` to `high` above the table (m), leaning by so much (rad), with its foot at x.
Scene can(double low, double high, double lean = 0.0, double x = 0.0) {
  Random random(1);
  const Cylinder cylinder = {kMiddle + x * Vec3::UnitX(), Eigen::AngleAxisd(lean, Vec3::UnitY()) * Vec3::UnitZ(), 0.04};
  return {cylinder, test::patchOf(cylinder, 100, low, high, random)};
}

TEST(StandsOn, HoldsForACanAndAHatOnATable) {
  EXPECT_EQ(can(0.0, 0.1).stands(), 1.0);
  EXPECT_EQ(can(0.02, 0.1).stands(), 1.0) << "samples end before the surface";
  Random random(2);
  const Cone hat = {kMiddle + 0.15 * Vec3::UnitZ(), -Vec3::UnitZ(), 20.0 * kDegree};
  EXPECT_EQ(Scene(hat, test::patchOf(hat, 100, 0.0, 0.13, random)).stands(), 1.0);
}

/// Whichever of its samples come first: near the tip they are nearer to the axis than the table is to the foot.
TEST(StandsOn, HoldsForWideHats) {
  Random random(3);
  const Cone hat = {kMiddle + 0.2 * Vec3::UnitZ(), -Vec3::UnitZ(), 40.0 * kDegree};
  for (int time = 0; time < 20; ++time) {
    EXPECT_EQ(Scene(hat, test::patchOf(hat, 100, 0.05, 0.19, random), 0.3, 0.2).stands(), 1.0);
  }
}

TEST(StandsOn, HoldsForATop) { EXPECT_EQ(can(-0.1, 0.0).stands(), 1.0); }

TEST(StandsOn, HoldsLessAsItLeans) {
  EXPECT_EQ(can(0.0, 0.1, 2.9 * kDegree).stands(), 1.0);
  EXPECT_NEAR(can(0.0, 0.1, 7.5 * kDegree).stands(), 0.5, 0.01);
  EXPECT_EQ(can(0.0, 0.1, 12.1 * kDegree).stands(), 0.0);
  EXPECT_EQ(can(0.0, 0.1, 90.0 * kDegree).stands(), 0.0) << "lying";
}

TEST(StandsOn, NeedsAnEndNearThePlane) {
  EXPECT_EQ(can(0.05, 0.15).stands(), 0.0);
  EXPECT_EQ(can(-0.05, 0.05).stands(), 0.0) << "it goes through";
}

TEST(StandsOn, NeedsThePlaneAroundItsFoot) {
  // Within its length of .1 and its width of .08 m from the edge.
  EXPECT_EQ(can(0.0, 0.1, 0.0, 0.47).stands(), 1.0);
  EXPECT_EQ(can(0.0, 0.1, 0.0, 0.49).stands(), 0.0);
}

TEST(StandsOn, IsNotAskedOfBallsAndPlanesNorWithoutSamples) {
  EXPECT_EQ(Scene(Sphere{kMiddle + 0.04 * Vec3::UnitZ(), 0.04}, {}).stands(), 0.0);
  EXPECT_EQ(Scene(Plane{kMiddle, Vec3::UnitX()}, {}).stands(), 0.0);
  EXPECT_EQ(Scene(Cylinder{kMiddle, Vec3::UnitZ(), 0.04}, {}).stands(), 0.0);
}

}  // namespace
}  // namespace primitect::standing_test
