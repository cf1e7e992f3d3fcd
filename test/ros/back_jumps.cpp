// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Bags in a loop and two sources on one topic.
#include "ros/back_jumps.h"

#include <gtest/gtest.h>

#include <chrono>

namespace primitect::back_jumps_test {
namespace {

using namespace ros_layer;
using std::chrono::milliseconds;

/// Feeds stamps (s) to it, one each 30 ms by the clock.
class Feed {
 public:
  void operator()(double stamp) {
    now_ += milliseconds(30);
    const bool is_back = stamp < last_;
    last_ = stamp;
    if (is_back) jumps.back(ros::Time(stamp), now_);
    jumps.cloud(ros::Time(stamp));
  }
  bool often() const { return jumps.often(now_); }
  void wait(int seconds) { now_ += std::chrono::seconds(seconds); }

  BackJumps jumps;

 private:
  SteadyClock::time_point now_ = SteadyClock::time_point() + std::chrono::hours(1);
  double last_ = 0.0;
};

TEST(BackJumps, OfABagInALoopAreNotOften) {
  Feed feed;
  for (int round = 0; round < 8; ++round) {
    // Of its 51 clouds the first ones may be missed, each time others.
    for (int k = round % 3; k < 51; ++k) feed(1000.0 + k / 15.0);
    EXPECT_FALSE(feed.often()) << round;
  }
  EXPECT_EQ(feed.jumps.count(), 7u);
}

TEST(BackJumps, OfTwoSourcesThatTakeTurnsAreOften) {
  Feed feed;
  for (int k = 0; k < 3; ++k) {
    feed(1000.0 + k / 30.0);
    EXPECT_FALSE(feed.often()) << k;
    feed(900.0 + k / 30.0);
  }
  EXPECT_TRUE(feed.often());
  feed.wait(9);
  EXPECT_TRUE(feed.often());
  feed.wait(2);
  EXPECT_FALSE(feed.often());
}

TEST(BackJumps, OfASlowSourceAmongTheCloudsOfAFastOneAreOften) {
  for (const int clouds_between : {6, 10, 12, 15, 30}) {
    Feed feed;
    bool often = false;
    for (int k = 0; k < 10; ++k) {
      const double seconds = k * clouds_between / 30.0;
      for (int cloud = 0; cloud < clouds_between; ++cloud) feed(1000.0 + seconds + cloud / 30.0);
      feed(900.0 + seconds);
      often = often || feed.often();
    }
    EXPECT_TRUE(often) << clouds_between;
  }
}

TEST(BackJumps, ThatAreFarApartAreNotOften) {
  Feed feed;
  for (int k = 0; k < 6; ++k) {
    feed(1000.0 + k);
    feed(900.0 + k);
    EXPECT_FALSE(feed.often()) << k;
    feed.wait(6);
  }
}

TEST(BackJumps, OfTwoSourcesAreOftenAfterALoopToo) {
  Feed feed;
  for (int round = 0; round < 3; ++round) {
    for (int k = 0; k < 20; ++k) feed(1000.0 + k / 15.0);
  }
  for (int k = 0; k < 4; ++k) {
    feed(2000.0 + k / 30.0);
    feed(1500.0 + k / 30.0);
  }
  EXPECT_TRUE(feed.often());
}

}  // namespace
}  // namespace primitect::back_jumps_test
