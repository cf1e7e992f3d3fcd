// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of cans and hats against the table that they stand on, and lids.
#include "core/ends_on_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/frame_around.h"
#include "test/support/exact_shapes.h"

namespace primitect::ends_on_faces_test {
namespace {

constexpr double kReach = 0.01;      // m
constexpr double kRounding = 1e-12;  // m

/// A table of 0.8 m x 0.8 m, 1 m away, seen from above at an angle.
const Vec3 kUp = Vec3(0, -0.8, -0.6), kRight = Vec3::UnitX(), kAcross = kUp.cross(kRight), kMiddle = Vec3(0, 0, 1);

Detection table() {
  Detection plane;
  plane.shape = Plane{kMiddle, kUp};
  plane.extent.origin = kMiddle;
  plane.extent.rotation << kRight, kAcross, kUp;
  plane.extent.size = Vec3(0.8, 0.8, 0);
  for (const auto& [u, v] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
    plane.extent.hull.push_back(kMiddle + 0.4 * u * kRight + 0.4 * v * kAcross);
  }
  return plane;
}

/// The axis goes from `from` to `to`; of a cone the first is its narrow end.
Extent between(const Vec3& from, const Vec3& to, double radius_small, double radius) {
  Extent extent;
  extent.origin = 0.5 * (from + to);
  extent.rotation = frameAround((to - from).normalized(), (to - from).unitOrthogonal());
  extent.size.z() = (to - from).norm();
  extent.radius_small = radius_small, extent.radius = radius;
  return extent;
}

Vec3 endOf(const Extent& extent, double side) {
  return extent.origin + side * 0.5 * extent.size.z() * extent.rotation.col(2);
}

/// A can of this radius whose axis leaves the table at this place, from `low` to `high` above it (m).
struct Can {
  Vec3 foot = kMiddle;
  double low = -0.006, high = 0.2, radius = 0.04;
  Vec3 up = kUp;
  Extent extent() const { return between(foot + low * up, foot + high * up, 0.0, radius); }
  Cylinder shape() const { return {foot, up, radius}; }
  Extent ended() const {
    Extent moved = extent();
    endOn(table(), kReach, shape(), moved);
    return moved;
  }
};

TEST(EndsOnFaces, OfACanIsTheTable) {
  const Extent ended = Can().ended();
  EXPECT_NEAR(ended.size.z(), 0.2, kRounding);
  EXPECT_LT((endOf(ended, -1.0) - kMiddle).norm(), kRounding);
  EXPECT_LT((endOf(ended, 1.0) - (kMiddle + 0.2 * kUp)).norm(), kRounding) << "the other end stays";
  EXPECT_EQ(ended.radius, 0.04);
}

TEST(EndsOnFaces, IsFoundWhicheverWayTheAxisPoints) {
  Can can;
  can.up = -kUp, can.low = -0.2, can.high = 0.006;
  const Extent ended = can.ended();
  EXPECT_NEAR(ended.size.z(), 0.2, kRounding);
  EXPECT_LT((endOf(ended, 1.0) - kMiddle).norm(), kRounding);
}

TEST(EndsOnFaces, OfATiltedCanIsWhereItsAxisMeetsTheTable) {
  Can can;
  can.up = Eigen::AngleAxisd(0.2, kRight) * kUp;
  const Extent ended = can.ended();
  EXPECT_NEAR(distance(Plane{kMiddle, kUp}, endOf(ended, -1.0)), 0.0, kRounding);
  EXPECT_LT((endOf(ended, 1.0) - endOf(can.extent(), 1.0)).norm(), kRounding);
}

TEST(EndsOnFaces, OfACanBelowAShelfIsTheShelf) {
  Can hanging;
  hanging.low = -0.2, hanging.high = 0.006;
  const Extent ended = hanging.ended();
  EXPECT_NEAR(ended.size.z(), 0.2, kRounding);
  EXPECT_LT((endOf(ended, 1.0) - kMiddle).norm(), kRounding);
}

TEST(EndsOnFaces, IsTheTableWhereSomeOfTheSideIsMissing) {
  Can short_of;
  short_of.low = 0.5 * kReach;
  const Extent ended = short_of.ended();
  EXPECT_NEAR(ended.size.z(), 0.2, kRounding);
  EXPECT_LT((endOf(ended, -1.0) - kMiddle).norm(), kRounding);
}

TEST(EndsOnFaces, IsTheLidOfWhatIsSeenFromAbove) {
  // The table is the lid of a pot that goes on below it.
  for (const double beyond : {0.008, -0.005}) {
    Can pot;
    pot.low = -0.3, pot.high = beyond;
    const Extent ended = pot.ended();
    EXPECT_NEAR(ended.size.z(), 0.3, kRounding) << beyond;
    EXPECT_LT((endOf(ended, 1.0) - kMiddle).norm(), kRounding) << beyond;
    EXPECT_LT((endOf(ended, -1.0) - (kMiddle - 0.3 * kUp)).norm(), kRounding) << beyond;
  }
}

TEST(EndsOnFaces, StaysWhereNothingSaysThatItEndsThere) {
  const auto stays = [](const Can& can) { return std::abs(can.ended().size.z() - (can.high - can.low)) < 1e-12; };
  Can above, through, lying, beside, flat;
  above.low = 0.7 * kReach;
  EXPECT_TRUE(stays(above)) << "before the table by more than is lost";
  through.low = -1.1 * kReach;
  EXPECT_TRUE(stays(through)) << "farther behind than noise reaches";
  lying.up = Eigen::AngleAxisd(0.3, kRight) * kUp;
  EXPECT_TRUE(stays(lying)) << "17 deg askew";
  beside.foot = kMiddle + 0.42 * kRight;
  EXPECT_TRUE(stays(beside)) << "its axis 2 cm beside the table";
  flat.low = -0.009, flat.high = 0.009;
  EXPECT_TRUE(stays(flat)) << "half of it is no noise";
}

TEST(EndsOnFaces, IsMovedAtTheEdgeOfTheTableToo) {
  Can at_edge;
  at_edge.foot = kMiddle + 0.405 * kRight;
  EXPECT_NEAR(at_edge.ended().size.z(), 0.2, kRounding);
}

TEST(EndsOnFaces, OfAConeTakesItsRadiusAlong) {
  const double half_angle = 0.3, slope = std::tan(half_angle);
  // Apex up, and apex down: a funnel that stands on its narrow end.
  const Vec3 apex = kMiddle + 0.2 * kUp;
  Extent hat = between(apex - 0.02 * kUp, kMiddle - 0.006 * kUp, 0.02 * slope, 0.206 * slope);
  endOn(table(), kReach, Cone{apex, -kUp, half_angle}, hat);
  EXPECT_NEAR(hat.radius, 0.2 * slope, kRounding);
  EXPECT_NEAR(hat.radius_small, 0.02 * slope, kRounding);
  EXPECT_NEAR(hat.size.z(), 0.18, kRounding);
  const Vec3 below = kMiddle - 0.1 * kUp;
  Extent funnel = between(kMiddle - 0.006 * kUp, kMiddle + 0.1 * kUp, 0.094 * slope, 0.2 * slope);
  endOn(table(), kReach, Cone{below, kUp, half_angle}, funnel);
  EXPECT_NEAR(funnel.radius_small, 0.1 * slope, kRounding);
  EXPECT_NEAR(funnel.radius, 0.2 * slope, kRounding);
  EXPECT_NEAR(funnel.size.z(), 0.1, kRounding);
}

TEST(EndsOnFaces, LeavesPlanesAndBallsAsTheyAre) {
  const Detection plane = table();
  Extent other = plane.extent;
  other.origin -= 0.005 * kUp;
  const Vec3 before = other.origin;
  endOn(plane, kReach, Plane{other.origin, kUp}, other);
  EXPECT_EQ(other.origin, before);
  Extent ball;
  ball.origin = kMiddle, ball.radius = 0.05;
  endOn(plane, kReach, Sphere{kMiddle, 0.05}, ball);
  EXPECT_EQ(ball.origin, kMiddle);
}

Detection detectionOf(const Can& can) {
  Detection item;
  item.shape = can.shape();
  item.extent = can.extent();
  return item;
}

/// Of which five make the reach.
double sigmaOfReach(const Vec3&) { return kReach / 5.0; }

TEST(EndFaces, OfACanAreTheTableAndItsLid) {
  Detection lid = table();
  lid.shape = Plane{kMiddle + 0.2 * kUp, kUp};
  lid.extent.origin += 0.2 * kUp;
  for (Vec3& corner : lid.extent.hull) corner = lid.extent.origin + 0.1 * (corner - kMiddle);
  Detection below = lid;  // as near as a face is looked for, but farther than the lid
  below.shape = Plane{kMiddle + 0.195 * kUp, kUp};
  for (const bool lid_first : {false, true}) {
    std::vector<Detection> items = {below, detectionOf(Can()), lid, table()};
    if (lid_first) std::swap(items[0], items[2]);
    nameEndFaces(sigmaOfReach, items);
    EXPECT_EQ(items[1].extent.face_at_minus_z, 3);
    EXPECT_EQ(items[1].extent.face_at_plus_z, lid_first ? 0 : 2);
    for (const std::size_t k : {0, 2, 3}) {
      EXPECT_EQ(items[k].extent.face_at_minus_z, kNoFace) << k;
      EXPECT_EQ(items[k].extent.face_at_plus_z, kNoFace) << k;
    }
  }
}

TEST(EndFaces, WereSeen) {
  Detection can = detectionOf(Can());
  const int both = kEndAtMinusZ | kEndAtPlusZ;
  for (const int unseen : {both, int{kEndsUnknown}}) {
    can.extent.unseen_ends = static_cast<std::uint8_t>(unseen);
    std::vector<Detection> items = {can, table()};
    nameEndFaces(sigmaOfReach, items);
    EXPECT_EQ(items[0].extent.unseen_ends, unseen == both ? kEndAtPlusZ : kEndsUnknown);
  }
}

TEST(EndFaces, AreNoneOfACanBesideTheTableOrAboveIt) {
  Can beside, above;
  beside.foot = kMiddle + 0.5 * kRight;
  above.low = 0.02;
  std::vector<Detection> items = {table(), detectionOf(beside), detectionOf(above)};
  nameEndFaces(sigmaOfReach, items);
  for (const Detection& item : items) {
    EXPECT_EQ(item.extent.face_at_minus_z, kNoFace);
    EXPECT_EQ(item.extent.face_at_plus_z, kNoFace);
  }
}

TEST(MayStandOn, HoldsWhereAnEndIsNoFartherThanAQuarterOfTheLength) {
  Can can;
  EXPECT_TRUE(mayStandOn(table(), kReach, can.extent()));
  for (const double high : {0.2, -0.2}) {  // it stands on the table, or hangs below
    for (const double way : {1.0, -1.0}) {
      can.high = high;
      can.low = way * (high > 0.0 ? 0.048 : -0.048) * (way > 0.0 ? 0.8 : 1.2);
      EXPECT_TRUE(mayStandOn(table(), kReach, can.extent())) << high << " " << way;
      can.low *= 1.5;
      EXPECT_FALSE(mayStandOn(table(), kReach, can.extent())) << high << " " << way;
    }
  }
}

TEST(MayStandOn, IsNotWhereItGoesThrough) {
  Can can;
  can.low = -0.1, can.high = 0.1;
  EXPECT_FALSE(mayStandOn(table(), kReach, can.extent()));
}

TEST(MayStandOn, AsksWhereTheAxisMeetsThePlaneAndHow) {
  Can beside;
  beside.foot = kMiddle + 0.45 * kRight;
  EXPECT_FALSE(mayStandOn(table(), kReach, beside.extent()));
  for (const double lean : {0.3, 0.4}) {
    Can can;
    can.up = Eigen::AngleAxisd(lean, kRight) * kUp;
    EXPECT_EQ(mayStandOn(table(), kReach, can.extent()), lean < 0.349) << lean;
  }
}

}  // namespace
}  // namespace primitect::ends_on_faces_test
