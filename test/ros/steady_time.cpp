// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Milliseconds a frame, whatever runs how often in it.
#include "ros/steady_time.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace primitect::steady_time_test {
namespace {

using namespace ros_layer;

constexpr double kNapMilliseconds = 20.0;

void nap() { std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(kNapMilliseconds)); }

StageSummary summaryOf(const StageTimes& times, const std::string& stage) {
  for (const StageSummary& summary : times.summaries()) {
    if (summary.stage == stage) return summary;
  }
  ADD_FAILURE() << "no stage " << stage;
  return {};
}

TEST(StageTimes, AddUpAStageThatRunsTwiceInAFrame) {
  StageTimes times;
  for (int frame = 0; frame < 3; ++frame) {
    times.begin();
    for (int round = 0; round < 2; ++round) {
      nap();
      times.stageDone("vote");
      times.stageDone("cluster");
    }
    times.end();
  }
  ASSERT_EQ(times.summaries().size(), 3u);
  EXPECT_GE(summaryOf(times, "vote").median, 2 * kNapMilliseconds);  // sleeping never ends early
  EXPECT_GE(summaryOf(times, "total").median, summaryOf(times, "vote").median);
}

TEST(StageTimes, TellWhatComesAfterAFrameApartFromItsTotal) {
  StageTimes times;
  times.begin();
  times.stageDone("vote");
  times.end();
  nap();
  times.recordAfter("publish");
  EXPECT_GE(summaryOf(times, "publish").median, kNapMilliseconds);
  EXPECT_LT(summaryOf(times, "total").median, summaryOf(times, "publish").median);
  EXPECT_EQ(times.summaries().back().stage, "total");
}

TEST(StageTimes, KeepTheOrderOfTheStagesWithTheTotalLast) {
  StageTimes times;
  for (const int rounds : {1, 2}) {
    times.begin();
    for (int round = 0; round < rounds; ++round) {
      times.stageDone("sample");
      times.stageDone("normals");
    }
    times.stageDone("message");
    times.end();
  }
  std::vector<std::string> stages;
  for (const StageSummary& summary : times.summaries()) stages.push_back(summary.stage);
  EXPECT_EQ(stages, (std::vector<std::string>{"sample", "normals", "message", "total"}));
}

TEST(StageTimes, ForgetAFrameThatWasNotFinished) {
  StageTimes times;
  times.begin();
  nap();
  times.stageDone("read");
  times.begin();  // an exception ended the frame before
  times.stageDone("read");
  times.end();
  EXPECT_EQ(summaryOf(times, "read").max, summaryOf(times, "read").median);
  EXPECT_LT(summaryOf(times, "read").max, summaryOf(times, "total").max + 1e-9);
}

}  // namespace
}  // namespace primitect::steady_time_test
