// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Poses that go on as before.
#include "primitect/steady_pose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/hull.h"
#include "core/random.h"
#include "test/support/exact_shapes.h"

namespace primitect::steady_pose_test {
namespace {

using test::angle;

/// Of the points of a plane, in its coordinates, as it is measured; the plane lies somewhere.
Extent extentAround(const List<Vec2>& points) {
  Extent extent;
  const Eigen::Matrix3d place = Eigen::AngleAxisd(0.7, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const List<Vec2> corners = convexHull(points, 1e-4);
  const Rectangle sides = smallestRectangle(corners);
  const Vec3 from(0.3, -0.2, 0.8);
  const auto inSpace = [&](const Vec2& v) -> Vec3 { return place * Vec3(v.x(), v.y(), 0.0); };
  extent.origin = from + inSpace(sides.middle);
  extent.rotation << inSpace(sides.x), inSpace({-sides.x.y(), sides.x.x()}), place.col(2);
  extent.size = Vec3(sides.size.x(), sides.size.y(), 0.0);
  for (const Vec2& corner : corners) extent.hull.push_back(from + inSpace(corner));
  return extent;
}

/// Points within a shape that holds so much of x^2, y^2; noise (m) at its border.
List<Vec2> noisyBorder(double width, double height, bool round, double noise, Random& random) {
  List<Vec2> points;
  for (int k = 0; k < 400; ++k) {
    const double turn = 2.0 * M_PI * k / 400.0;
    Vec2 p(std::cos(turn), std::sin(turn));
    if (!round) p /= p.cwiseAbs().maxCoeff();
    const double right = noise * random.gaussian(), up = noise * random.gaussian();
    points.push_back(p.cwiseProduct(Vec2(0.5 * width, 0.5 * height)) + Vec2(right, up));
  }
  return points;
}

/// Largest turn (rad) of x from one to the next of many frames, as measured and when turned as before.
struct Turns {
  double measured = 0.0, steady = 0.0;
};

Turns turnsOf(double width, double height, bool round) {
  Random random(5);
  Turns turns;
  Vec3 measured = Vec3::Zero(), before = Vec3::Zero();
  for (int frame = 0; frame < 50; ++frame) {
    Extent extent = extentAround(noisyBorder(width, height, round, 0.002, random));
    if (frame > 0) turns.measured = std::max(turns.measured, angle(measured, extent.rotation.col(0)));
    measured = extent.rotation.col(0);
    turnAsBefore(Kind::plane, before, extent);
    if (frame > 0) turns.steady = std::max(turns.steady, angle(before, extent.rotation.col(0)));
    before = waveringDirection(Kind::plane, extent);
  }
  return turns;
}

TEST(SteadyPose, KeepsXOfWhatIsAsLongAsWideOrRound) {
  constexpr double kSmall = 0.15;  // rad
  for (const bool round : {false, true}) {
    const Turns turns = turnsOf(0.1, 0.1, round);
    EXPECT_GT(turns.measured, 0.7) << round << ": nothing to keep";
    EXPECT_LT(turns.steady, round ? 1e-6 : kSmall) << round;
  }
  EXPECT_LT(turnsOf(0.2, 0.1, false).steady, kSmall);
}

TEST(SteadyPose, TellsTheRectangleAlongX) {
  Random random(6);
  for (const bool round : {false, true}) {
    Extent extent = extentAround(noisyBorder(0.1, 0.09, round, 0.001, random));
    const Extent measured = extent;
    const Vec3 x = (measured.rotation.col(1) + 0.3 * measured.rotation.col(0)).normalized();
    turnAsBefore(Kind::plane, x, extent);
    EXPECT_GT(angle(extent.rotation.col(0), measured.rotation.col(0)), 0.7);
    EXPECT_NEAR((extent.rotation.transpose() * extent.rotation - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-9);
    EXPECT_NEAR(extent.rotation.determinant(), 1.0, 1e-9);
    EXPECT_LT(angle(extent.rotation.col(2), measured.rotation.col(2)), 1e-6);
    Vec3 low = Vec3::Constant(1.0), high = -low;
    for (const Vec3& corner : extent.hull) {
      const Vec3 there = extent.rotation.transpose() * (corner - extent.origin);
      low = low.cwiseMin(there), high = high.cwiseMax(there);
    }
    EXPECT_LT((high - 0.5 * extent.size).norm(), 1e-9) << round;
    EXPECT_LT((low + 0.5 * extent.size).norm(), 1e-9) << round;
  }
}

TEST(SteadyPose, FollowsAPlaneThatTurns) {
  for (const double degrees : {1.0, 5.0, 9.0}) {
    for (const double height : {0.1, 0.05}) {
      Extent first = extentAround({{0, 0}, {0.1, 0}, {0.1, height}, {0, height}});
      const double turn = degrees * M_PI / 180.0;
      const Vec3 before = Eigen::AngleAxisd(turn, first.rotation.col(2)) * first.rotation.col(0);
      const Extent own = first;
      turnAsBefore(Kind::plane, before, first);
      EXPECT_LT(angle(first.rotation.col(0), own.rotation.col(0)), 1e-6) << degrees << " " << height;
    }
  }
  // At once: the nearest side goes on.
  for (const double degrees : {20.0, 40.0, 140.0, 200.0}) {
    Extent extent = extentAround({{0, 0}, {0.1, 0}, {0.1, 0.05}, {0, 0.05}});
    const double turn = degrees * M_PI / 180.0;
    const Vec3 longer = extent.rotation.col(0), before = Eigen::AngleAxisd(turn, extent.rotation.col(2)) * longer;
    turnAsBefore(Kind::plane, before, extent);
    EXPECT_LT(angle(extent.rotation.col(0), std::cos(turn) > 0.0 ? longer : Vec3(-longer)), 1e-6) << degrees;
    EXPECT_NEAR(extent.size.x(), 0.1, 1e-9) << degrees;
  }
}

Extent rectangle(double width, double height) {
  return extentAround({{0, 0}, {width, 0}, {width, height}, {0, height}});
}

/// The angle (deg) by which x is turned from the longer side where it was along the shorter one.
double turnedFromLonger(Extent extent) {
  const Vec3 longer = extent.rotation.col(0), shorter = extent.rotation.col(1);
  turnAsBefore(Kind::plane, shorter, extent);
  return angle(longer, extent.rotation.col(0)) * 180.0 / M_PI;
}

TEST(SteadyPose, StaysAtTheShorterSideWhereTheOtherIsLongerByAQuarterAtMost) {
  EXPECT_NEAR(turnedFromLonger(rectangle(0.12, 0.1)), 90.0, 1e-6);
  EXPECT_NEAR(turnedFromLonger(rectangle(0.13, 0.1)), 0.0, 1e-6);
  Random random(7);
  EXPECT_NEAR(turnedFromLonger(extentAround(noisyBorder(0.12, 0.1, true, 0.0, random))), 90.0, 1e-6);
  EXPECT_NEAR(turnedFromLonger(extentAround(noisyBorder(0.13, 0.1, true, 0.0, random))), 0.0, 1e-6) << "an oval";
}

TEST(SteadyPose, TakesNoSquareForRoundInWhateverDirectionItWas) {
  for (const double degrees : {10.0, 22.5, 40.0}) {
    Extent extent = rectangle(0.1, 0.1);
    const Vec3 x = extent.rotation.col(0);
    turnAsBefore(Kind::plane, Eigen::AngleAxisd(degrees * M_PI / 180.0, extent.rotation.col(2)) * x, extent);
    EXPECT_LT(angle(extent.rotation.col(0), x), 1e-6) << degrees;
  }
}

TEST(SteadyPose, AsksNoDirectionThatIsFarFromThePlane) {
  const Extent square = rectangle(0.1, 0.1);
  const Vec3 x = square.rotation.col(0), y = square.rotation.col(1), z = square.rotation.col(2);
  for (const double degrees : {50.0, 70.0}) {
    Extent extent = square;
    turnAsBefore(Kind::plane, std::cos(degrees * M_PI / 180.0) * y + std::sin(degrees * M_PI / 180.0) * z, extent);
    EXPECT_LT(angle(extent.rotation.col(0), degrees < 60.0 ? y : x), 1e-6) << degrees;
  }
}

TEST(SteadyPose, TurnsACylinderRoundAboutItsSeenSide) {
  Extent extent;
  extent.unseen_ends = kEndAtMinusZ;
  extent.face_at_minus_z = 7;
  for (int again = 0; again < 2; ++again) {
    turnAsBefore(Kind::cylinder, {0.1, 0.0, -1.0}, extent);
    EXPECT_EQ(extent.rotation, Eigen::Matrix3d(Vec3(1.0, -1.0, -1.0).asDiagonal()));
    EXPECT_EQ(extent.unseen_ends, kEndAtPlusZ);
    EXPECT_EQ(extent.face_at_plus_z, 7);
    EXPECT_EQ(extent.face_at_minus_z, kNoFace);
  }
  turnAsBefore(Kind::cylinder, {0.1, 0.0, 1.0}, extent);
  EXPECT_EQ(extent.unseen_ends, kEndAtMinusZ);
  for (const int ends : {0, kEndAtMinusZ | kEndAtPlusZ, int{kEndsUnknown}}) {
    extent = Extent();
    extent.unseen_ends = static_cast<std::uint8_t>(ends);
    turnAsBefore(Kind::cylinder, -Vec3::UnitZ(), extent);
    EXPECT_EQ(extent.unseen_ends, ends);
  }
}

TEST(SteadyPose, LeavesAsTheyAreConesBallsAndWhatHasNoBefore) {
  const Extent plane = extentAround({{0, 0}, {0.1, 0}, {0.1, 0.05}, {0, 0.05}});
  for (const Kind kind : {Kind::sphere, Kind::cone}) {
    Extent extent = plane;
    turnAsBefore(kind, -plane.rotation.col(2), extent);
    EXPECT_EQ(extent.rotation, plane.rotation);
    EXPECT_TRUE(waveringDirection(kind, extent).isZero());
  }
  for (const Vec3& before : {Vec3(Vec3::Zero()), Vec3(plane.rotation.col(2)), Vec3(Vec3::Constant(NAN))}) {
    Extent extent = plane;
    turnAsBefore(Kind::plane, before, extent);
    EXPECT_EQ(extent.rotation, plane.rotation) << before.transpose();
    EXPECT_EQ(extent.size, plane.size);
  }
  EXPECT_EQ(waveringDirection(Kind::plane, plane), Vec3(plane.rotation.col(0)));
  EXPECT_EQ(waveringDirection(Kind::cylinder, plane), Vec3(plane.rotation.col(2)));
}

}  // namespace
}  // namespace primitect::steady_pose_test
