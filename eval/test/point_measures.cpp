// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Assignment, DOD and coverage on hand-made cases with known answers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/metrics.h"
#include "eval/test/hand_made.h"

namespace point_measures_test {
namespace {

using namespace primitect;
using namespace primitect::eval;

TEST(Assignment, TakesTheClosestShapeWithinDistanceAndAngle) {
  const Plane floor{Vec3::Zero(), Vec3::UnitZ()};
  const Plane shelf{Vec3(0, 0, 0.06), Vec3::UnitZ()};
  const Cloud cloud = cloudOf(
      {{{1, 0, 0.01}, tilted(0)}, {{1, 0, 0.04}, tilted(14)}, {{1, 0, 0.01}, tilted(16)}, {{1, 0, 0.12}, tilted(0)}});
  const std::vector<int> labels = assign(cloud, {floor, shelf}, Rules());
  EXPECT_EQ(labels, (std::vector<int>{0, 1, -1, -1}));
  const Distances distances = measureDistances(cloud, {floor, shelf}, labels);
  EXPECT_NEAR(distances.closest[2], 0.01, 1e-6);
  EXPECT_NEAR(distances.closest[3], 0.06, 1e-6);
  EXPECT_NEAR(distances.own[1], 0.02, 1e-6);
  EXPECT_TRUE(std::isnan(distances.own[3]));
}

TEST(Assignment, IgnoresTheSignOfNormals) {
  const Cloud cloud = cloudOf({{{1, 0, 0.01}, -tilted(3)}});
  EXPECT_EQ(assign(cloud, {Plane()}, Rules())[0], 0);
}

TEST(Assignment, PrefersAFartherShapeWhoseNormalAgrees) {
  const Plane floor{Vec3::Zero(), Vec3::UnitZ()};
  const Plane wall{Vec3::Zero(), Vec3::UnitY()};
  const Cloud cloud = cloudOf({{{1, 0.02, 0.01}, Vec3::UnitY()}});
  EXPECT_EQ(assign(cloud, {floor, wall}, Rules())[0], 1);
}

TEST(Assignment, LeavesOutMissingPointsAndMissingNormals) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  const Cloud cloud = cloudOf({{Vec3::Constant(kMissing), Vec3::UnitZ()}, {{1, 0, 0.01}, Vec3::Constant(kMissing)}});
  EXPECT_EQ(assign(cloud, {Plane()}, Rules()), (std::vector<int>{-1, -1}));
  EXPECT_TRUE(std::isnan(measureDistances(cloud, {Plane()}, {-1, -1}).closest[0]));
}

TEST(Assignment, KeepsTheClosestOfSeveralThatPass) {
  const auto at = [](double z) { return Plane{Vec3(0, 0, z), Vec3::UnitZ()}; };
  const Cloud cloud = cloudOf({{{1, 0, 0.0}, tilted(0)}});
  EXPECT_EQ(assign(cloud, {at(0.01), at(0.03), at(0.02)}, Rules())[0], 0);
}

TEST(Assignment, TakesTheDistanceOfItsRules) {
  const Cloud cloud = cloudOf({{{1, 0, 0.03}, tilted(0)}});
  Rules narrow;
  narrow.max_distance = 0.02;
  EXPECT_EQ(assign(cloud, {Plane()}, Rules())[0], 0);
  EXPECT_EQ(assign(cloud, {Plane()}, narrow)[0], -1);
}

TEST(Assignment, RefusesRulesOutOfRange) {
  Rules rules;
  rules.max_angle_deg = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(assign(cloudOf({{{1, 0, 0}, tilted(0)}}), {Plane()}, rules), std::invalid_argument);
}

TEST(Assignment, RefusesACloudWithoutNormals) {
  Cloud cloud;
  cloud.reset(1, 1, false);
  EXPECT_THROW(assign(cloud, {Plane()}, Rules()), std::invalid_argument);
}

TEST(ObjectDistance, IsTheShiftBetweenParallelPlanes) {
  const Cloud cloud = cloudOf({{{1, 0, 0.01}, tilted(0)}, {{0, 1, -0.02}, tilted(0)}, {{0, 0, 9}, tilted(0)}});
  const Plane shifted{Vec3(0, 0, 0.007), Vec3::UnitZ()};
  EXPECT_NEAR(objectDistance(cloud, {0, 0, 1}, 0, Plane(), shifted), 0.007, 1e-9);
}

TEST(ObjectDistance, LeavesMissingPointsOut) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  const Cloud cloud = cloudOf({{{1, 0, 0}, tilted(0)}, {Vec3::Constant(kMissing), tilted(0)}});
  EXPECT_NEAR(objectDistance(cloud, {0, 0}, 0, Plane(), Plane{Vec3(0, 0, 0.007), Vec3::UnitZ()}), 0.007, 1e-9);
}

TEST(ObjectDistance, IsTheDifferenceOfRadiiForConcentricSpheres) {
  const Cloud cloud = cloudOf({{{1.1, 0, 0}, Vec3::UnitX()}, {{0, 0.8, 0}, Vec3::UnitY()}});
  EXPECT_NEAR(objectDistance(cloud, {0, 0}, 0, Sphere{Vec3::Zero(), 1.0}, Sphere{Vec3::Zero(), 1.03}), 0.03, 1e-7);
}

/// Coverage of a cloud by some shapes.
class Covered {
 public:
  Covered(const Cloud& cloud, const std::vector<Shape>& found, const Rules& rules)
      : count_(found.size()),
        labels_(assign(cloud, found, rules)),
        distances_(measureDistances(cloud, found, labels_)) {}

  std::vector<double> points(const std::vector<double>& epsilons) const { return pointCoverage(distances_, epsilons); }
  std::vector<double> shapes(const std::vector<double>& epsilons) const {
    return shapeCoverage(distances_, labels_, count_, epsilons);
  }

 private:
  std::size_t count_;
  std::vector<int> labels_;
  Distances distances_;
};

TEST(Coverage, CountsPointsNearAnyShapeAndAveragesOverShapes) {
  const Plane floor{Vec3::Zero(), Vec3::UnitZ()};
  const Plane high{Vec3(0, 0, 1), Vec3::UnitZ()};
  // Floor: 1 of 2 points within 0.01; high: 2 of 2; one point belongs to nothing.
  const Cloud cloud = cloudOf({{{1, 0, 0.005}, tilted(0)},
                               {{1, 0, 0.03}, tilted(0)},
                               {{1, 0, 1.001}, tilted(0)},
                               {{1, 0, 0.999}, tilted(0)},
                               {{1, 0, 0.5}, tilted(0)}});
  const std::vector<Shape> found = {floor, high, Sphere{Vec3(9, 9, 9), 1.0}};
  const Covered covered(cloud, found, Rules());
  EXPECT_EQ(covered.points({0.01, 0.02, 0.04}), (std::vector<double>{0.6, 0.6, 0.8}));
  EXPECT_EQ(covered.shapes({0.01, 0.04}), (std::vector<double>{0.75, 1.0}));
}

TEST(Coverage, IsStrictlyBelowEpsilon) {
  const Cloud cloud = cloudOf({{{1, 0, 0.25}, tilted(0)}});
  Rules rules;
  rules.max_distance = 1.0;
  const Covered covered(cloud, {Plane()}, rules);
  EXPECT_EQ(covered.points({0.0, 0.25, 0.26}), (std::vector<double>{0.0, 0.0, 1.0}));
}

TEST(Coverage, SaysNothingOfShapesWhereNoneHasPoints) {
  const Cloud cloud = cloudOf({{{1, 0, 0.5}, tilted(0)}});
  EXPECT_TRUE(Covered(cloud, {Plane()}, Rules()).shapes({0.01}).empty());
  EXPECT_TRUE(Covered(cloud, {}, Rules()).shapes({0.01}).empty());
  EXPECT_EQ(Covered(cloud, {}, Rules()).points({0.01}), (std::vector<double>{0.0}));
}

TEST(Coverage, LeavesMissingPointsOut) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  const Cloud cloud = cloudOf({{{1, 0, 0.0}, tilted(0)}, {Vec3::Constant(kMissing), tilted(0)}});
  EXPECT_EQ(Covered(cloud, {Plane()}, Rules()).points({0.01}), (std::vector<double>{1.0}));
}

TEST(Coverage, OfAShapeTakesTheDistanceToItAndNotToACloserOneWithAnotherNormal) {
  const Plane floor{Vec3::Zero(), Vec3::UnitZ()};
  const Plane wall{Vec3::Zero(), Vec3::UnitY()};
  const Cloud cloud = cloudOf({{{1, 0.02, 0.001}, Vec3::UnitY()}});
  const Covered covered(cloud, {floor, wall}, Rules());
  EXPECT_EQ(covered.points({0.01}), (std::vector<double>{1.0}));
  EXPECT_EQ(covered.shapes({0.01, 0.03}), (std::vector<double>{0.0, 1.0}));
}

}  // namespace
}  // namespace point_measures_test
