// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What keeps its number from frame to frame, and what does not.
#include "primitect/tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/random.h"

namespace primitect::tracker_test {
namespace {

constexpr double kFrame = 1.0 / 30.0;  // s

Sighting ball(const Vec3& center, double radius = 0.05) {
  return {Kind::sphere, false, center, Vec3::UnitZ(), radius, 0.0};
}

Sighting can(const Vec3& middle, const Vec3& axis = Vec3::UnitZ()) {
  return {Kind::cylinder, false, middle, axis, 0.04, 0.06};
}

Sighting top(const Vec3& middle, const Vec3& normal = Vec3::UnitZ()) {
  return {Kind::plane, false, middle, normal, 0.0, 0.1};
}

std::vector<std::uint32_t> idsOf(const std::vector<Track>& tracks) {
  std::vector<std::uint32_t> ids;
  for (const Track& track : tracks) ids.push_back(track.id);
  return ids;
}

using Ids = std::vector<std::uint32_t>;

TEST(Tracker, GivesThingsTheSameNumbersInAnyOrder) {
  const Sighting red = ball({0, 0, 1}), blue = ball({0.12, 0, 1}), tin = can({0.3, 0, 1});
  Tracker tracker;
  EXPECT_EQ(idsOf(tracker.update({red, blue, tin}, 0.0)), (Ids{1, 2, 3}));
  EXPECT_EQ(idsOf(tracker.update({tin, red, blue}, kFrame)), (Ids{3, 1, 2}));
  EXPECT_EQ(idsOf(tracker.update({blue, ball({0.5, 0, 1})}, 2 * kFrame)), (Ids{2, 4}));
}

TEST(Tracker, FollowsWhatMovesAndWhatNoiseMoves) {
  Random random(1);
  Tracker tracker;
  // Two balls roll past each other at half a metre a second, 12 cm apart.
  for (int frame = 0; frame < 60; ++frame) {
    const double way = 0.5 * kFrame * frame - 0.5, noise = 0.005 * random.gaussian();
    const Sighting there = ball({way, noise, 1.0}), back = ball({-way, 0.12, 1.0 + noise});
    ASSERT_EQ(idsOf(tracker.update({there, back}, kFrame * frame)), (Ids{1, 2})) << frame;
  }
}

TEST(Tracker, ForgetsNoThingForOneSightingThatIsOff) {
  Tracker tracker;
  const Sighting good = ball({0, 0, 1}, 0.05), off = ball({0.04, 0, 1}, 0.064), good_again = ball({-0.03, 0, 1}, 0.047);
  EXPECT_EQ(idsOf(tracker.update({good}, 0.0)), Ids{1});
  EXPECT_EQ(idsOf(tracker.update({off}, kFrame)), Ids{1});
  EXPECT_EQ(idsOf(tracker.update({good_again}, 2 * kFrame)), Ids{1}) << "as the one before the last";
  EXPECT_EQ(idsOf(tracker.update({off}, 3 * kFrame)), Ids{1});
  EXPECT_EQ(idsOf(tracker.update({good_again}, 4 * kFrame)), Ids{1});
}

TEST(Tracker, LooksNoFartherForASightingThatIsOlder) {
  Tracker tracker;
  tracker.update({ball({0, 0, 1})}, 0.0);
  tracker.update({ball({0, 0, 1})}, 1.9);
  EXPECT_EQ(idsOf(tracker.update({ball({0.45, 0, 1})}, 1.933)), Ids{2});
}

TEST(Tracker, GivesANeighborNoNumberOfAThingThatFlickers) {
  Tracker tracker;
  const Sighting flickers = can({0, 0, 1}), stays = can({0.2, 0, 1});
  tracker.update({flickers, stays}, 0.0);
  tracker.update({stays}, 0.6);
  tracker.update({flickers, stays}, 1.2);
  EXPECT_EQ(idsOf(tracker.update({can({0.175, 0, 1})}, 1.2 + kFrame)), Ids{2});
}

TEST(Tracker, CountsFramesSinceTheFirstAlsoThoseWithoutIt) {
  Tracker tracker;
  EXPECT_EQ(tracker.update({ball({0, 0, 1})}, 0.0)[0].age, 0u);
  EXPECT_EQ(tracker.update({ball({0, 0, 1})}, kFrame)[0].age, 1u);
  tracker.update({}, 2 * kFrame);
  const Track again = tracker.update({ball({0, 0, 1}), ball({1, 0, 1})}, 3 * kFrame)[0];
  EXPECT_EQ(again.id, 1u);
  EXPECT_EQ(again.age, 3u);
}

TEST(Tracker, WaitsForWhatIsHiddenAsLongAsItsPatience) {
  for (const double hidden : {0.4, 0.6}) {
    Tracker tracker(0.5);
    tracker.update({ball({0, 0, 1})}, 10.0);
    tracker.update({}, 10.0 + 0.5 * hidden);
    EXPECT_EQ(idsOf(tracker.update({ball({0, 0, 1})}, 10.0 + hidden)), Ids{hidden < 0.5 ? 1u : 2u});
  }
}

TEST(Tracker, CountsFramesWhereStampsStandStillOrRunBack) {
  for (const double step : {0.0, -kFrame}) {
    for (const int hidden : {50, 70}) {
      Tracker tracker;
      double time = 10.0;
      tracker.update({ball({0, 0, 1})}, time);
      for (int frame = 0; frame < hidden; ++frame) tracker.update({ball({1, 0, 1})}, time += step);
      const Track back = tracker.update({ball({0, 0, 1})}, time += step).front();
      EXPECT_EQ(back.id, hidden < 60 ? 1u : 3u) << step;
    }
  }
}

TEST(Tracker, FollowsAPlaneWhoseEndIsHidden) {
  Tracker tracker;
  tracker.update({top({0, 0, 1})}, 0.0);
  EXPECT_EQ(idsOf(tracker.update({top({0.06, 0, 1})}, kFrame)), Ids{1});
  // Another height, another side, and beside it.
  EXPECT_EQ(idsOf(tracker.update({top({0.06, 0, 1.1})}, 2 * kFrame)), Ids{2});
  EXPECT_EQ(idsOf(tracker.update({top({0.06, 0, 1.1}, -Vec3::UnitZ())}, 3 * kFrame)), Ids{3});
  EXPECT_EQ(idsOf(tracker.update({top({0.4, 0, 1.1}, -Vec3::UnitZ())}, 4 * kFrame)), Ids{4});
}

TEST(Tracker, TakesACylinderForAConeButNoOtherKindForAnother) {
  Tracker tracker;
  tracker.update({can({0, 0, 1})}, 0.0);
  Sighting cone = can({0, 0, 1}, -Vec3::UnitZ());  // an axis of a cylinder has no sign
  cone.kind = Kind::cone;
  EXPECT_EQ(idsOf(tracker.update({cone}, kFrame)), Ids{1});
  EXPECT_EQ(idsOf(tracker.update({can({0, 0, 1})}, 2 * kFrame)), Ids{1});
  Sighting inside = can({0, 0, 1});
  inside.concave = true;
  EXPECT_EQ(idsOf(tracker.update({inside, ball({0, 0, 1}, 0.04), top({0, 0, 1})}, 3 * kFrame)), (Ids{2, 3, 4}));
}

TEST(Tracker, TellsThingsBySizeAndDirection) {
  Tracker tracker;
  tracker.update({ball({0, 0, 1}), can({1, 0, 1})}, 0.0);
  EXPECT_EQ(idsOf(tracker.update({ball({0, 0, 1}, 0.08), can({1, 0, 1}, Vec3::UnitX())}, kFrame)), (Ids{3, 4}));
}

/// What is told of each of these, one after the other: where it pointed before.
std::vector<Vec3> beforeIn(const std::vector<Sighting>& sightings) {
  Tracker tracker;
  std::vector<Vec3> before;
  for (std::size_t k = 0; k < sightings.size(); ++k) {
    before.push_back(tracker.update({sightings[k]}, kFrame * static_cast<double>(k)).at(0).direction_before);
  }
  return before;
}

TEST(Tracker, TellsWhereAnAxisOrALongerSidePointed) {
  const Vec3 lying = Vec3(1.0, 0.02, 0.0).normalized(), other_way = Vec3(-1.0, 0.02, 0.0).normalized();
  const Sighting tube = can({0, 0, 1}, lying), turned = can({0, 0, 1}, other_way);
  EXPECT_EQ(beforeIn({tube, turned, turned, tube}), (std::vector<Vec3>{Vec3::Zero(), lying, -other_way, -other_way}));
  Sighting front = top({0, 0, 1}), back = front;
  front.across = Vec3::UnitY(), back.across = Vec3(0.05, -1.0, 0.0).normalized();
  EXPECT_EQ(beforeIn({front, back, front}), (std::vector<Vec3>{Vec3::Zero(), Vec3::UnitY(), -back.across}));
}

TEST(Tracker, GoesOnWithTheDirectionThatItIsTold) {
  Tracker tracker;
  Sighting lid = top({0, 0, 1});
  lid.across = Vec3::UnitY();
  tracker.update({lid, ball({1, 0, 1})}, 0.0);
  tracker.turned(0, Vec3::UnitX());
  lid.across = -Vec3::UnitY();
  // In another order.
  const std::vector<Track>& tracks = tracker.update({ball({1, 0, 1}), lid}, kFrame);
  EXPECT_EQ(tracks[0].direction_before, Vec3::Zero());
  EXPECT_EQ(tracks[1].direction_before, Vec3::UnitX());
  tracker.turned(1, -Vec3::UnitX());
  EXPECT_EQ(tracker.update({lid}, 2 * kFrame)[0].direction_before, -Vec3::UnitX());
}

TEST(Tracker, TellsNoneOfConesAndBallsButOfATubeThatWasACone) {
  Sighting cone = can({0, 0, 1});
  cone.kind = Kind::cone;
  const Sighting tube = can({0, 0, 1}, -Vec3::UnitZ());
  const Vec3 none = Vec3::Zero(), up = Vec3::UnitZ();
  // The axis of a cone points away from its apex, which way ever that of the tube does that it is taken for again.
  EXPECT_EQ(beforeIn({tube, cone, cone, tube}), (std::vector<Vec3>{none, none, none, -up}));
  EXPECT_EQ(beforeIn({cone, tube, cone, tube}), (std::vector<Vec3>{none, up, none, up}));
  EXPECT_EQ(beforeIn({ball({0, 0, 1}), ball({0, 0, 1})}), (std::vector<Vec3>{none, none}));
}

/// A part of the floor around x (m).
Sighting floorAt(double x, double reach = 0.6) {
  Sighting part = top({x, 0, 1});
  part.reach = reach;
  return part;
}

TEST(Tracker, GoesOnWithTheOldestNumberOfAPlaneThatIsSeenInParts) {
  Tracker tracker;
  const Sighting left = floorAt(-0.15), right = floorAt(0.15);
  EXPECT_EQ(idsOf(tracker.update({left}, 0.0)), (Ids{1}));
  EXPECT_EQ(idsOf(tracker.update({left, right}, kFrame)), (Ids{1, 2}));
  EXPECT_EQ(idsOf(tracker.update({right}, 2 * kFrame)), (Ids{1}));
  EXPECT_EQ(idsOf(tracker.update({right}, 3 * kFrame)), (Ids{1}));
}

TEST(Tracker, GivesATopBesideAHiddenOneNoNumberOfIt) {
  Tracker tracker;
  const Sighting one = floorAt(-0.05, 0.15), other = floorAt(0.05, 0.15);
  EXPECT_EQ(idsOf(tracker.update({one, other}, 0.0)), (Ids{1, 2}));
  EXPECT_EQ(idsOf(tracker.update({other}, kFrame)), (Ids{2}));
  EXPECT_EQ(idsOf(tracker.update({one, other}, 2 * kFrame)), (Ids{1, 2}));
}

TEST(Tracker, StartsAnewWithOne) {
  Tracker tracker;
  tracker.update({ball({0, 0, 1}), ball({1, 0, 1})}, 0.0);
  tracker.startAnew();
  const Track track = tracker.update({ball({1, 0, 1})}, kFrame)[0];
  EXPECT_EQ(track.id, 1u);
  EXPECT_EQ(track.age, 0u);
}

TEST(Tracker, ForgetsThingsButNotTheirNumbers) {
  Tracker tracker;
  tracker.update({ball({0, 0, 1})}, 0.0);
  tracker.forget();
  const Track track = tracker.update({ball({0, 0, 1})}, kFrame)[0];
  EXPECT_EQ(track.id, 2u);
  EXPECT_EQ(track.age, 0u);
}

TEST(Tracker, GivesWhatHasNoPlaceANewNumberEachTime) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Tracker tracker;
  const std::vector<Sighting> odd = {ball({kNan, 0, 1}), ball({0, 0, 1}, 0.0), top({0, 0, 1}, {kNan, 0, 0})};
  EXPECT_EQ(idsOf(tracker.update(odd, 0.0)), (Ids{1, 2, 3}));
  EXPECT_EQ(idsOf(tracker.update(odd, kFrame)), (Ids{4, 5, 6}));
  EXPECT_TRUE(tracker.update({}, kNan).empty());
}

}  // namespace
}  // namespace primitect::tracker_test
