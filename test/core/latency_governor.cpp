// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Frames on an imagined machine, whose costs follow a formula: no clock is needed to see whether the bound is kept.
#include "primitect/latency_governor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/random.h"

namespace primitect::latency_governor_test {
namespace {

constexpr double kLeastShare = 0.1;

/// What a frame takes: a part that is always the same (reading, measuring), one that grows with the square of the share
/// (votes), and one in proportion: one second together at full effort on a machine that does nothing else.
struct Machine {
  double fixed = 0.3;
  double votes = 0.2;
  double load = 1.0;
  double noise = 0.0;         ///< standard deviation of the time's logarithm
  double interrupted = 0.0;   ///< share of the frames that take four times as long
  double search_part = 0.75;  ///< of a frame's time is over when it is asked how many more samples are in time
  double skipped_part = 0.1;  ///< of a frame's time is saved by skipping the rest of the search

  /// Of most frames.
  double typical(double share) const { return load * (fixed + votes * share * share + (1.0 - fixed - votes) * share); }

  double seconds(double share, Random& random) const {
    const double once = random.uniform() < interrupted ? 4.0 : 1.0;
    return once * typical(share) * std::exp(noise * random.gaussian());
  }
};

struct Frames {
  std::vector<double> seconds, shares;

  /// Of the frames from `begin` on.
  double missed(double bound, std::size_t begin) const {
    const auto over = std::count_if(seconds.begin() + static_cast<std::ptrdiff_t>(begin), seconds.end(),
                                    [bound](double s) { return s > bound; });
    return static_cast<double>(over) / static_cast<double>(seconds.size() - begin);
  }
  double leastShare(std::size_t begin) const {
    return *std::min_element(shares.begin() + static_cast<std::ptrdiff_t>(begin), shares.end());
  }
  double largestShare(std::size_t begin) const {
    return *std::max_element(shares.begin() + static_cast<std::ptrdiff_t>(begin), shares.end());
  }
};

Frames run(LatencyGovernor& governor, const Machine& machine, int count, Random& random) {
  Frames frames;
  for (int i = 0; i < count; ++i) {
    governor.beginFrame();
    const double share = governor.share();
    const double full = machine.seconds(share, random);
    const double in_time = governor.shareInTime(machine.search_part * full);
    frames.seconds.push_back((1.0 - (1.0 - in_time) * machine.skipped_part) * full);
    frames.shares.push_back(share);
    governor.endFrame(frames.seconds.back());
  }
  return frames;
}

/// So many frames are enough to get used to anything; at 30 Hz less than two seconds.
constexpr std::size_t kGettingUsed = 50;

TEST(LatencyGovernor, LeavesTheEffortAloneWhenThereIsTime) {
  LatencyGovernor governor(1.3, kLeastShare);
  Random random(1);
  EXPECT_EQ(run(governor, {}, 300, random).leastShare(0), 1.0);
  EXPECT_EQ(governor.missed(), 0u);
  EXPECT_EQ(governor.frames(), 300u);
}

/// Bounds and machines on which a share above the least one keeps the bound.
struct Case {
  double fixed, votes, noise, bound;
};

class KeepsTheBound : public ::testing::TestWithParam<Case> {};

TEST_P(KeepsTheBound, OfNineteenFramesInTwentyOnceItIsUsedToTheMachine) {
  const auto [fixed, votes, noise, bound] = GetParam();
  Machine machine;
  machine.fixed = fixed;
  machine.votes = votes;
  machine.noise = noise;
  machine.interrupted = 0.01;
  LatencyGovernor governor(bound, kLeastShare);
  Random random(2);
  const Frames frames = run(governor, machine, 2000, random);
  EXPECT_LE(frames.missed(bound, kGettingUsed), 0.05);
  // The aim is 0.85 of the bound, noise needs its two deviations, and steps up end within a tenth of it.
  const double typical = machine.typical(frames.shares.back());
  const bool no_more = frames.shares.back() == 1.0 || frames.shares.back() == kLeastShare;
  EXPECT_TRUE(no_more || typical > 0.7 * bound * std::exp(-2.5 * noise)) << typical;
}

INSTANTIATE_TEST_SUITE_P(Machines, KeepsTheBound,
                         ::testing::Values(Case{0.0, 0.0, 0.0, 0.5}, Case{0.0, 0.0, 0.1, 0.5}, Case{0.0, 0.2, 0.3, 0.5},
                                           Case{0.3, 0.2, 0.0, 0.5}, Case{0.3, 0.2, 0.1, 0.8}, Case{0.3, 0.2, 0.3, 0.8},
                                           Case{0.6, 0.2, 0.0, 0.8}, Case{0.6, 0.2, 0.1, 1.0}, Case{0.3, 0.2, 0.3, 1.3},
                                           Case{0.0, 1.0, 0.0, 0.3}, Case{0.0, 1.0, 0.1, 0.7}));

TEST(LatencyGovernor, GoesDownWithinTenFramesWhenTheLoadTrebles) {
  LatencyGovernor governor(1.3, kLeastShare);
  Random random(3);
  Machine machine;
  run(governor, machine, 200, random);
  machine.load = 3.0;
  const Frames frames = run(governor, machine, 200, random);
  EXPECT_EQ(frames.missed(1.3, 10), 0.0);
}

TEST(LatencyGovernor, ComesBackToAllOfTheEffortWhenTheLoadIsGone) {
  LatencyGovernor governor(1.3, kLeastShare);
  Random random(4);
  Machine machine;
  machine.noise = 0.05;
  machine.load = 3.0;
  run(governor, machine, 200, random);
  EXPECT_LT(governor.share(), 0.3);
  machine.load = 1.0;
  EXPECT_EQ(run(governor, machine, 300, random).shares.back(), 1.0);
}

TEST(LatencyGovernor, StaysWithOneShareWhileNothingChanges) {
  LatencyGovernor governor(0.8, kLeastShare);
  Random random(5);
  Machine machine;
  machine.noise = 0.05;
  const Frames frames = run(governor, machine, 1000, random);
  EXPECT_LT(frames.largestShare(200) / frames.leastShare(200), 1.25);
  std::size_t changes = 0;
  for (std::size_t i = 201; i < frames.shares.size(); ++i) changes += frames.shares[i] != frames.shares[i - 1];
  EXPECT_LT(changes, 800 / 40);
}

TEST(LatencyGovernor, DoesNotMindASingleFrameThatWasInterrupted) {
  LatencyGovernor governor(1.1, kLeastShare);
  Random random(6);
  Machine machine;
  run(governor, machine, 100, random);
  machine.load = 20.0;
  run(governor, machine, 1, random);
  machine.load = 1.0;
  EXPECT_EQ(run(governor, machine, 100, random).leastShare(0), 1.0);
}

TEST(LatencyGovernor, GoesDownWhenTooManySingleFramesMissTheBound) {
  LatencyGovernor governor(1.1, kLeastShare);
  for (int i = 0; i < 400; ++i) {
    governor.beginFrame();
    governor.endFrame((i % 5 == 0 ? 2.0 : 1.0) * governor.share());
  }
  EXPECT_LE(2.0 * governor.share(), 1.1);
}

/// What the rest of a frame takes with a share of its samples, measured on tables (latency_governor.cpp); between these
/// a straight line.
double partOfRest(double share) {
  const std::vector<std::array<double, 2>> measured = {{0.0, 0.13}, {0.1, 0.50}, {0.2, 0.62}, {0.4, 0.80},
                                                       {0.6, 0.90}, {0.8, 0.93}, {1.0, 1.0}};
  std::size_t i = 1;
  while (share > measured[i][0]) ++i;
  const auto [from, low] = measured[i - 1];
  const auto [to, high] = measured[i];
  return low + (high - low) * (share - from) / (to - from);
}

/// A frame that is asked at 0.4 s and takes 0.4 + rest with all samples. Returns the share of them that it is told to
/// draw.
double shareOf(LatencyGovernor& governor, double rest) {
  governor.beginFrame();
  const double share = governor.shareInTime(0.4);
  governor.endFrame(0.4 + rest * partOfRest(share));
  return share;
}

TEST(LatencyGovernor, TriesAgainWhatItSkipped) {
  LatencyGovernor governor(1.0, 1.0);  // it cannot use fewer samples
  for (int i = 0; i < 20; ++i) EXPECT_EQ(shareOf(governor, 0.4), 1.0);
  for (int i = 0; i < 20; ++i) shareOf(governor, 1.6);
  EXPECT_EQ(shareOf(governor, 1.6), 0.0);
  int frames = 0;
  while (frames < 100 && shareOf(governor, 0.4) < 1.0) ++frames;
  EXPECT_LT(frames, 60);
}

TEST(LatencyGovernor, DrawsAsManySamplesAsAreInTime) {
  for (const double rest : {0.65, 0.7, 0.8, 0.9}) {
    LatencyGovernor governor(1.0, 1.0);
    for (int i = 0; i < 40; ++i) shareOf(governor, rest);
    const std::uint64_t missed = governor.missed();
    double least = 1.0, most = 0.0;
    for (int i = 0; i < 40; ++i) {
      const double share = shareOf(governor, rest);
      least = std::min(least, share), most = std::max(most, share);
    }
    EXPECT_GT(least, 0.15) << rest;
    EXPECT_LT(most, 1.0) << rest;
    EXPECT_EQ(governor.missed(), missed) << rest;
  }
}

TEST(LatencyGovernor, DrawsFewerTheLaterItIs) {
  double before = 1.0;
  for (const double elapsed : {0.45, 0.5, 0.55, 0.6}) {
    LatencyGovernor governor(1.0, kLeastShare);
    for (int i = 0; i < 20; ++i) shareOf(governor, 0.58);
    governor.beginFrame();
    const double share = governor.shareInTime(elapsed);
    EXPECT_LT(share, before) << elapsed;
    EXPECT_GT(share, 0.1) << elapsed;
    before = share;
  }
}

TEST(LatencyGovernor, LearnsNothingFromTwoCutsAndForgetsALittle) {
  LatencyGovernor governor(1.0, 1.0);
  const auto frame = [&governor](double search) {  // two draws that take so long each
    governor.beginFrame();
    const double first = governor.shareInTime(0.2);
    const double then = 0.2 + search * partOfRest(first);
    const double second = governor.shareInTime(then);
    governor.endFrame(then + search * partOfRest(second));
    return first;
  };
  for (int i = 0; i < 20; ++i) EXPECT_EQ(frame(0.3), 1.0);
  for (int i = 0; i < 40; ++i) frame(0.55);
  EXPECT_LT(frame(0.55), 1.0);
  int frames = 0;
  while (frames < 100 && frame(0.3) < 1.0) ++frames;
  EXPECT_LT(frames, 60);
}

TEST(LatencyGovernor, SkipsTheRestOfTheSearchWhenAnyOfItWouldMissTheBound) {
  LatencyGovernor governor(1.0, kLeastShare);
  for (int i = 0; i < 20; ++i) {
    governor.beginFrame();
    EXPECT_EQ(governor.shareInTime(0.2), 1.0) << "frame " << i;
    EXPECT_EQ(governor.shareInTime(0.4), 1.0) << "frame " << i;
    governor.endFrame(0.8);
  }
  governor.beginFrame();
  EXPECT_EQ(governor.shareInTime(0.35), 1.0);  // interrupted, but what comes after it is the same as ever
  EXPECT_EQ(governor.shareInTime(0.55), 1.0);
  governor.endFrame(0.95);
  governor.beginFrame();
  EXPECT_EQ(governor.shareInTime(0.3), 1.0);   // it goes on to 0.9
  EXPECT_EQ(governor.shareInTime(0.85), 0.0);  // but from here to 1.25
  governor.endFrame(0.9);
  EXPECT_EQ(governor.missed(), 0u);
}

TEST(LatencyGovernor, IsOutOfTimeBeyondTheBoundAlsoInTheFirstFrame) {
  LatencyGovernor governor(0.5, kLeastShare);
  governor.beginFrame();
  EXPECT_EQ(governor.shareInTime(0.4), 1.0);
  EXPECT_EQ(governor.shareInTime(0.6), 0.0);
}

TEST(LatencyGovernor, SavesSamplesRatherThanSkipForEver) {
  LatencyGovernor governor(0.95, kLeastShare);
  Random random(7);
  Machine machine;
  machine.skipped_part = 0.2;  // skipping alone would keep the bound
  run(governor, machine, 1, random);
  EXPECT_LT(run(governor, machine, 4, random).shares.back(), 1.0);
  governor.beginFrame();
  EXPECT_EQ(governor.shareInTime(machine.search_part * machine.seconds(governor.share(), random)), 1.0);
}

TEST(LatencyGovernor, SaysWhenEvenTheLeastShareMissesTheBound) {
  LatencyGovernor governor(0.2, kLeastShare);  // less than the fixed part
  Random random(8);
  EXPECT_FALSE(governor.hopeless());
  run(governor, {}, 20, random);
  EXPECT_TRUE(governor.hopeless());
  EXPECT_EQ(governor.share(), kLeastShare);
  EXPECT_EQ(governor.missed(), 20u);
  Machine fast;
  fast.load = 0.1;
  run(governor, fast, 2, random);
  EXPECT_TRUE(governor.hopeless());  // two frames do not tell
  run(governor, fast, 40, random);
  EXPECT_FALSE(governor.hopeless());
}

TEST(LatencyGovernor, TellsHowManyOfTheLastFramesMissedTheBound) {
  LatencyGovernor governor(0.2, kLeastShare);
  const auto frames = [&governor](int count, double seconds) {
    for (int k = 0; k < count; ++k) {
      governor.beginFrame();
      governor.endFrame(seconds);
    }
  };
  frames(60, 0.1);
  EXPECT_EQ(governor.framesLately(), 60u);
  frames(3, 0.3);
  EXPECT_EQ(governor.missedLately(), 3u);
  EXPECT_FALSE(governor.missesBound());  // of 63
  frames(1, 0.3);
  EXPECT_TRUE(governor.missesBound());
  frames(36, 0.1);
  EXPECT_EQ(governor.framesLately(), 100u);
  EXPECT_FALSE(governor.missesBound());  // 4 of 100
  frames(2, 0.3);
  EXPECT_EQ(governor.missedLately(), 6u);
  EXPECT_TRUE(governor.missesBound());
  frames(98, 0.1);
  EXPECT_EQ(governor.missedLately(), 2u);
  EXPECT_EQ(governor.missed(), 6u);
}

TEST(LatencyGovernor, GivesTheSameSharesForTheSameTimes) {
  Machine machine;
  machine.noise = 0.3;
  LatencyGovernor first(0.6, kLeastShare), second(0.6, kLeastShare);
  Random a(9), b(9);
  EXPECT_EQ(run(first, machine, 500, a).shares, run(second, machine, 500, b).shares);
}

std::string refusal(double bound, double least_share) {
  try {
    LatencyGovernor(bound, least_share);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(LatencyGovernor, RefusesWhatIsNoBoundAndNoShare) {
  EXPECT_NE(refusal(0.0, 0.5).find("above 0"), std::string::npos);
  EXPECT_NE(refusal(std::nan(""), 0.5).find("nan"), std::string::npos);
  EXPECT_NE(refusal(1.0, 0.0).find("share"), std::string::npos);
  EXPECT_NE(refusal(1.0, 1.5).find("1.5"), std::string::npos);
  EXPECT_EQ(refusal(1.0, 1.0), "");
}

}  // namespace
}  // namespace primitect::latency_governor_test
