// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Extents that were moved, turned and cut by known amounts.
#include "eval/extent_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "primitect/transforms.h"

namespace extent_errors_test {
namespace {

using namespace primitect;
using namespace primitect::eval;

constexpr double kTiny = 1e-9;

/// From z = begin to z = end on the z axis; upside down: with its axis the other way round.
Extent onAxis(double begin, double end, bool upside_down = false) {
  Extent extent;
  extent.origin = Vec3(0, 0, 0.5 * (begin + end));
  extent.size.z() = end - begin;
  if (upside_down) extent.rotation = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return extent;
}

Extent square(const Vec3& corner, double side) {
  Extent extent;
  extent.origin = corner + Vec3(side / 2, side / 2, 0);
  for (const Vec3& c : {Vec3(0, 0, 0), Vec3(side, 0, 0), Vec3(side, side, 0), Vec3(0, side, 0)})
    extent.hull.push_back(corner + c);
  return extent;
}

Detection withExtent(const Shape& shape, const Extent& extent) {
  Detection detection;
  detection.shape = shape;
  detection.extent = extent;
  return detection;
}

const Cylinder kTube{Vec3::Zero(), Vec3::UnitZ(), 0.05};

TEST(ExtentErrors, OfATubeAreWhatIsTooMuchAtEachEnd) {
  const ExtentErrors errors = extentErrors(kTube, onAxis(0.1, 0.3), withExtent(kTube, onAxis(0.12, 0.31)));
  ASSERT_TRUE(errors.beyond_ends);
  EXPECT_NEAR((*errors.beyond_ends)[0], -0.02, kTiny);
  EXPECT_NEAR((*errors.beyond_ends)[1], 0.01, kTiny);
  EXPECT_FALSE(errors.outline_overlap);
}

TEST(ExtentErrors, OfATubeGoByTheEndsOfTheDetectionWhoseAxisPointsTheOtherWay) {
  const ExtentErrors errors = extentErrors(kTube, onAxis(0.1, 0.3), withExtent(kTube, onAxis(0.12, 0.31, true)));
  EXPECT_NEAR((*errors.beyond_ends)[0], 0.01, kTiny);
  EXPECT_NEAR((*errors.beyond_ends)[1], -0.02, kTiny);
}

TEST(ExtentErrors, OfAConeAreTakenAlongItsAxis) {
  const Cone cone{Vec3::Zero(), Vec3::UnitZ(), 0.3};
  EXPECT_NEAR((*extentErrors(cone, onAxis(0.1, 0.3), withExtent(cone, onAxis(0.1, 0.25))).beyond_ends)[1], -0.05,
              kTiny);
}

TEST(ExtentErrors, OfAPlaneAreTheShareOfBothOutlinesThatTheyHaveInCommon) {
  const Plane plane{Vec3::Zero(), Vec3::UnitZ()};
  // Half of each square is the other's: a third of both together.
  const ExtentErrors errors =
      extentErrors(plane, square(Vec3::Zero(), 1.0), withExtent(plane, square(Vec3(0.5, 0, 0), 1.0)));
  ASSERT_TRUE(errors.outline_overlap);
  EXPECT_NEAR(*errors.outline_overlap, 1.0 / 3.0, kTiny);
  EXPECT_FALSE(errors.beyond_ends);
}

TEST(ExtentErrors, DoNotDependOnTheFrame) {
  const Plane plane{Vec3::Zero(), Vec3::UnitZ()};
  Detections all;
  all.items = {withExtent(kTube, onAxis(0.1, 0.3)), withExtent(kTube, onAxis(0.12, 0.31)),
               withExtent(plane, square(Vec3::Zero(), 1.0)), withExtent(plane, square(Vec3(0.5, 0, 0), 1.0))};
  transformDetections(Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()), all);
  const auto errors = [&all](std::size_t k) {
    return extentErrors(all.items[k].shape, all.items[k].extent, all.items[k + 1]);
  };
  EXPECT_NEAR((*errors(0).beyond_ends)[0], -0.02, kTiny);
  EXPECT_NEAR((*errors(0).beyond_ends)[1], 0.01, kTiny);
  EXPECT_NEAR(*errors(2).outline_overlap, 1.0 / 3.0, kTiny);
}

TEST(ExtentErrors, OfATiltedTubeAreTakenAlongTheTrueAxis) {
  Extent tilted = onAxis(0.1, 0.3);
  tilted.rotation = Eigen::AngleAxisd(M_PI / 3.0, Vec3::UnitX()).toRotationMatrix();  // half as high
  const ExtentErrors errors = extentErrors(kTube, onAxis(0.1, 0.3), withExtent(kTube, tilted));
  EXPECT_NEAR((*errors.beyond_ends)[0], -0.05, kTiny);
  EXPECT_NEAR((*errors.beyond_ends)[1], -0.05, kTiny);
}

TEST(ExtentErrors, OfAPlaneWithoutAnOutlineAreNone) {
  const Plane plane{Vec3::Zero(), Vec3::UnitZ()};
  Extent line = square(Vec3::Zero(), 1.0);
  line.hull.resize(2);
  for (const Extent& none : {Extent(), line})
    EXPECT_FALSE(extentErrors(plane, square(Vec3::Zero(), 1.0), withExtent(plane, none)).outline_overlap);
}

TEST(ExtentErrors, OfAPlaneDoNotDependOnTheOrderOfTheCorners) {
  const Plane plane{Vec3::Zero(), Vec3::UnitZ()};
  Extent clockwise = square(Vec3::Zero(), 2.0);
  std::reverse(clockwise.hull.begin(), clockwise.hull.end());
  const ExtentErrors errors = extentErrors(plane, square(Vec3::Zero(), 2.0), withExtent(plane, clockwise));
  EXPECT_NEAR(*errors.outline_overlap, 1.0, kTiny);
}

TEST(ExtentErrors, OfPlanesFarFromEachOtherAreNoOverlap) {
  const Plane plane{Vec3::Zero(), Vec3::UnitZ()};
  const ExtentErrors errors =
      extentErrors(plane, square(Vec3::Zero(), 1.0), withExtent(plane, square(Vec3(3, 0, 0), 1.0)));
  EXPECT_EQ(*errors.outline_overlap, 0.0);
}

TEST(ExtentErrors, OfASphereAreNone) {
  const ExtentErrors errors = extentErrors(Sphere(), Extent(), withExtent(Sphere(), Extent()));
  EXPECT_FALSE(errors.beyond_ends || errors.outline_overlap);
}

TEST(ExtentErrors, OfDifferentKindsAreRefused) {
  EXPECT_THROW(extentErrors(kTube, Extent(), withExtent(Sphere(), Extent())), std::invalid_argument);
}

}  // namespace
}  // namespace extent_errors_test
