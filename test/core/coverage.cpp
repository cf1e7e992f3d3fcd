// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shares of spheres, turns and outlines whose truth is known from geometry.
#include "core/coverage.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/extent.h"
#include "test/support/exact_shapes.h"

namespace primitect::coverage_test {
namespace {

using test::kDegree;

// 64 probes find a share to 0.05 at worst; 100 points blur its border by about 0.04: together root of squares.
constexpr double kTolerance = 0.06;

/// Evenly spread points of a sphere for which keep(direction) holds, with noise (m) of all axes.
template <class Keep>
std::vector<Vec3> pointsOf(const Sphere& sphere, int count, double noise, const Keep& keep, Random& random) {
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count) {
    const Vec3 direction = test::randomDirection(random);
    const Vec3 stray{random.gaussian(), random.gaussian(), random.gaussian()};
    if (keep(direction)) points.push_back(test::pointOn(sphere, direction).point + noise * stray);
  }
  return points;
}

float coverageOf(const Shape& shape, const std::vector<Vec3>& points) {
  return measureCoverage(shape, measureExtent(shape, points), points);
}

const Sphere kSphere = {Vec3(0.1, 0.0, 1.0), 0.1};

TEST(SphereCoverage, IsTheShareOfACap) {
  Random random(91);
  const Vec3 towards = -kSphere.center.normalized();
  for (const int count : {100, 300, 2000}) {
    for (const double half_opening : {45.0, 60.0, 90.0}) {
      const double cosine = std::cos(half_opening * kDegree);
      const auto points = pointsOf(
          kSphere, count, 0.002, [&](const Vec3& d) { return d.dot(towards) > cosine; }, random);
      EXPECT_NEAR(coverageOf(kSphere, points), 0.5 * (1.0 - cosine), kTolerance) << count << " " << half_opening;
    }
  }
}

TEST(SphereCoverage, OfAllSidesIsNearlyOne) {
  Random random(92);
  const auto points = pointsOf(
      kSphere, 1000, 0.002, [](const Vec3&) { return true; }, random);
  // Tuned for what one sensor sees: on the whole sphere some probes have few neighbours.
  EXPECT_GT(coverageOf(kSphere, points), 0.88f);
}

TEST(SphereCoverage, LeavesOutAQuarterThatIsHidden) {
  Random random(93);
  const auto points = pointsOf(
      kSphere, 500, 0.002, [](const Vec3& d) { return d.z() < 0.0 && !(d.x() > 0.0 && d.y() > 0.0); }, random);
  EXPECT_NEAR(coverageOf(kSphere, points), 0.375, kTolerance);
}

TEST(SphereCoverage, IsNotRaisedByAStraggler) {
  Random random(94);
  auto points = pointsOf(
      kSphere, 300, 0.0, [](const Vec3& d) { return d.z() < -0.7; }, random);
  const float before = coverageOf(kSphere, points);
  points.push_back(kSphere.center + Vec3(0, 0, kSphere.radius));
  EXPECT_LT(coverageOf(kSphere, points), before + 0.02f);
}

/// Points of a turning shape at angles (deg) of the given range.
template <class Round>
std::vector<Vec3> sector(const Round& shape, int count, double from_deg, double to_deg, double low, double high,
                         Random& random) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double angle = random.uniform(from_deg, to_deg) * kDegree;
    const Vec3 exact = test::pointOn(shape, random.uniform(low, high), angle).point;
    points.push_back(exact + 0.001 * Vec3{random.gaussian(), random.gaussian(), random.gaussian()});
  }
  return points;
}

const Cylinder kCylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
const Cone kCone = {Vec3(0, -0.1, 1), Vec3(0, 1, 0), 25.0 * kDegree};

TEST(ArcCoverage, IsTheShareOfTheTurn) {
  Random random(95);
  for (const int count : {60, 300, 2000}) {
    for (const double arc : {60.0, 120.0, 180.0, 300.0, 360.0}) {
      // The outermost of n angles are 1/n of the arc short of its ends, each, and scatter by as much; the widest gap
      // of a whole turn is above 8/n once in fifty draws of 60 angles.
      const double tolerance = 0.02 + (arc < 360.0 ? 4.0 : 8.0) / count * arc / 360.0;
      EXPECT_NEAR(coverageOf(kCylinder, sector(kCylinder, count, 30.0, 30.0 + arc, 0.0, 0.1, random)), arc / 360.0,
                  tolerance)
          << count << " " << arc;
      EXPECT_NEAR(coverageOf(kCone, sector(kCone, count, -80.0, -80.0 + arc, 0.02, 0.2, random)), arc / 360.0,
                  tolerance)
          << count << " " << arc;
    }
  }
}

TEST(ArcCoverage, AddsUpSeparateParts) {
  Random random(96);
  std::vector<Vec3> points = sector(kCylinder, 200, 0.0, 90.0, 0.0, 0.1, random);
  for (const Vec3& p : sector(kCylinder, 200, 150.0, 180.0, 0.0, 0.1, random)) points.push_back(p);
  EXPECT_NEAR(observedArc(kCylinder, measureExtent(kCylinder, points), points), 120.0 * kDegree, 6.0 * kDegree);
}

TEST(ArcCoverage, IsNotRaisedByAStraggler) {
  Random random(97);
  std::vector<Vec3> points = sector(kCylinder, 300, 0.0, 90.0, 0.0, 0.1, random);
  points.push_back(test::pointOn(kCylinder, 0.05, 225.0 * kDegree).point);
  EXPECT_NEAR(coverageOf(kCylinder, points), 0.25, 0.02);
}

TEST(ArcCoverage, OfAConeDoesNotCountDirectionsAtTheApex) {
  Random random(98);
  std::vector<Vec3> points = sector(kCone, 300, 0.0, 90.0, 0.02, 0.2, random);
  for (int i = 0; i < 20; ++i) points.push_back(kCone.apex + 0.002 * test::randomDirection(random));
  EXPECT_NEAR(coverageOf(kCone, points), 0.25, 0.03);
}

const Plane kPlane = {Vec3(0, 0, 1), -Vec3::UnitZ()};

/// Evenly spread points of a rectangle of 0.4 x 0.2 m for which keep(u, v) holds.
template <class Keep>
std::vector<Vec3> rectangle(int count, const Keep& keep, Random& random) {
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count) {
    const double u = random.uniform(-0.2, 0.2), v = random.uniform(-0.1, 0.1);
    if (keep(u, v)) points.push_back(test::pointOn(kPlane, u, v).point + Vec3(0, 0, 0.002 * random.gaussian()));
  }
  return points;
}

TEST(PlaneCoverage, OfAFullOutlineIsOne) {
  Random random(99);
  for (const int count : {60, 300, 2000}) {
    const auto points = rectangle(
        count, [](double, double) { return true; }, random);
    EXPECT_GT(coverageOf(kPlane, points), 1.0 - kTolerance) << count;
  }
}

TEST(PlaneCoverage, LeavesOutHoles) {
  Random random(100);
  // A round hole of a fifth of the area.
  const double radius = std::sqrt(0.2 * 0.08 / M_PI);
  for (const int count : {300, 2000}) {
    const auto points = rectangle(
        count, [&](double u, double v) { return std::hypot(u, v) > radius; }, random);
    EXPECT_NEAR(coverageOf(kPlane, points), 0.8, kTolerance) << count;
  }
}

TEST(PlaneCoverage, OfAnAngleIsItsShareOfTheHull) {
  Random random(101);
  // Three quarters of the rectangle; the hull cuts the missing quarter in half.
  const auto points = rectangle(
      1000, [](double u, double v) { return !(u > 0.0 && v > 0.0); }, random);
  EXPECT_NEAR(coverageOf(kPlane, points), 0.75 / 0.875, kTolerance);
}

/// Pixels of a camera that sees a table up to 2 m away at a slant, for which keep(point) holds.
template <class Keep>
std::vector<Vec3> pixelsOf(const Plane& table, int width, const Keep& keep) {
  std::vector<Vec3> points;
  for (int row = 0; row < 400; ++row) {
    for (int column = 0; column < width; ++column) {
      const Vec3 ray((column - 0.5 * width) / width, (row - 200) / 500.0, 1.0);
      const double depth = table.normal.dot(table.point) / table.normal.dot(ray);
      if (0.0 < depth && depth < 2.0 && keep(depth)) points.push_back(depth * ray);
    }
  }
  return points;
}

TEST(PlaneCoverage, OfATableSeenAtASlantIsThatOfItsSurface) {
  const auto coverage = [](double tilt_deg, int width, const auto& keep, Density density) {
    const double tilt = tilt_deg * kDegree;
    const Plane table = {Vec3(0.0, 0.1, 1.0), Vec3(0.0, -std::cos(tilt), -std::sin(tilt))};
    const std::vector<Vec3> points = pixelsOf(table, width, keep);
    return measureCoverage(table, measureExtent(table, points), points, density);
  };
  const auto everywhere = [](double) { return true; };
  EXPECT_LT(coverage(20.0, 100, everywhere, Density::of_surface), 0.9f) << "or this tells nothing";
  // So many widths that steps of some hundred points are a row, or nearly.
  for (int width = 100; width < 108; ++width)
    EXPECT_GT(coverage(20.0, width, everywhere, Density::of_pixels), 0.93f) << width;
  // At 35 deg it reaches from 0.73 to 2 m, as wide as it is far away: of an area of (4 - 0.53) / 2, what is between 1.2
  // and 1.6 m is 0.32.
  const auto near_and_far = [](double depth) { return depth < 1.2 || depth > 1.6; };
  EXPECT_NEAR(coverage(35.0, 100, near_and_far, Density::of_pixels), 0.68f, 0.08f);
}

/// One of every 100 pixels or so: in steps that change evenly, too, these are columns of some images.
TEST(PlaneCoverage, OfAWallIsOneWhateverTheSizeOfTheImage) {
  for (const auto& [width, height] :
       {std::pair(640, 276), std::pair(512, 512), std::pair(352, 352), std::pair(184, 184), std::pair(670, 670)}) {
    std::vector<Vec3> points;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) points.emplace_back(0.002 * column, 0.002 * row, 1.0);
    }
    const float coverage = measureCoverage(kPlane, measureExtent(kPlane, points), points, Density::of_pixels);
    EXPECT_GT(coverage, 0.9f) << width << " " << height;
  }
}

TEST(Coverage, IsNoneWithoutInliersAndAShareWithAFew) {
  for (const Shape& shape : {Shape(kPlane), Shape(kSphere), Shape(kCylinder), Shape(kCone)}) {
    EXPECT_EQ(measureCoverage(shape, {}, {}), 0.0f);
    for (const std::size_t count : {1, 2, 4}) {
      const std::vector<Vec3> points(count, project(shape, Vec3(0.03, 0.02, 0.9)));
      const float coverage = coverageOf(shape, points);
      EXPECT_TRUE(0.0f <= coverage && coverage <= 1.0f) << kindName(kindOf(shape)) << " " << count;
    }
  }
}

}  // namespace
}  // namespace primitect::coverage_test
