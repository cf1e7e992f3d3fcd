// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What eval/speed relies on: counted allocations, a clock that takes none, clouds that are what their names say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "eval/bench/allocations.h"
#include "eval/bench/harness.h"
#include "eval/bench/memory.h"
#include "eval/bench/scenes.h"

using namespace primitect;
using namespace primitect::bench;

namespace bench_harness_test {
namespace {

/// Where the compiler cannot see that nobody reads it.
void* volatile kept;

TEST(Allocations, AreCountedWhoeverAsks) {
  if (!canCountAllocations()) GTEST_SKIP() << "malloc cannot be replaced here";
  beginCounting();
  const auto by_new = std::make_unique<char[]>(1000);
  kept = by_new.get();
  void* const by_malloc = std::malloc(200);
  kept = by_malloc;
  const Allocations taken = endCounting();
  std::free(by_malloc);
  EXPECT_EQ(taken.count, 2u);
  EXPECT_EQ(taken.bytes, 1200u);
}

TEST(Allocations, StartAtZeroEachTime) {
  beginCounting();
  const auto first = std::make_unique<int>(1);
  kept = first.get();
  endCounting();
  const auto uncounted = std::make_unique<int>(2);
  kept = uncounted.get();
  beginCounting();
  EXPECT_EQ(endCounting().count, 0u);
}

TEST(FrameClock, AddsUpAStageThatRunsTwice) {
  FrameClock clock;
  clock.begin();
  for (const char* stage : {"vote", "segment", "vote"}) clock.stageDone(stage);
  clock.end();
  ASSERT_EQ(clock.stages().size(), 2u);
  EXPECT_STREQ(clock.stages()[0].first, "vote");
  EXPECT_LE(clock.stages()[0].second + clock.stages()[1].second, clock.cpuMs());
}

TEST(FrameClock, TakesTheFirstEndAndForgetsItWithTheNextFrame) {
  FrameClock clock;
  clock.begin();
  clock.end(5.0, 7.0);
  clock.end();
  EXPECT_EQ(clock.cpuMs(), 5.0);
  EXPECT_EQ(clock.wallMs(), 7.0);
  clock.begin();
  clock.end(1.0, 2.0);
  EXPECT_EQ(clock.cpuMs(), 1.0);
  EXPECT_TRUE(clock.stages().empty());
}

TEST(FrameClock, TakesNothingFromTheHeapWhileAFrameRuns) {
  FrameClock clock;
  beginCounting();
  clock.begin();
  for (const char* stage : {"read", "sample", "normals", "vote", "segment", "measure"}) clock.stageDone(stage);
  clock.end();
  EXPECT_EQ(endCounting().count, 0u);
}

TEST(Memory, PeakIsNeverBelowWhatIsResident) {
  forgetPeak();
  const long resident = statusKilobytes("VmRSS");
  EXPECT_GT(resident, 0);
  EXPECT_GE(statusKilobytes("VmHWM"), resident);
  EXPECT_THROW(statusKilobytes("VmNothing"), std::runtime_error);
}

struct Box {
  float low = INFINITY, high = -INFINITY;
};

Box boxOf(const std::vector<float>& values) {
  Box box;
  for (const float v : values) box = {std::min(box.low, v), std::max(box.high, v)};
  return box;
}

TEST(PaperCloud, IsTheSameSceneWithAnyNumberOfPoints) {
  const Cloud few = paperCloudOf(2000), many = paperCloudOf(200000);
  EXPECT_EQ(few.valid_count, 2000u);
  EXPECT_EQ(many.valid_count, 200000u);
  for (const Cloud* cloud : {&few, &many}) {
    ASSERT_TRUE(cloud->hasNormals());
    // The grid reaches from -2 to 2; noise and half a step add at most 0.06.
    EXPECT_NEAR(boxOf(cloud->x).low, -2.0, 0.06);
    EXPECT_NEAR(boxOf(cloud->x).high, 2.0, 0.06);
    EXPECT_NEAR(boxOf(cloud->y).high, 2.0, 0.06);
  }
  // The heights of one scene: a small part of the points cannot reach above all of them by more than noise.
  EXPECT_LT(boxOf(few.z).high, boxOf(many.z).high + 0.05);
}

double sumOfDepths(const Cloud& cloud) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cloud.size(); ++i) sum += cloud.valid(i) ? cloud.z[i] : 0.0;
  return sum;
}

TEST(DepthFrames, HaveTheirSizeAndAreMeasuredForTheMostPart) {
  for (const View view : {View::tabletop, View::clutter, View::wall}) {
    const std::vector<Cloud> frames = depthFrames(view, 160, 120, 2);
    ASSERT_EQ(frames.size(), 2u);
    for (const Cloud& frame : frames) {
      EXPECT_EQ(frame.width, 160u);
      EXPECT_EQ(frame.height, 120u);
      EXPECT_GT(frame.valid_count, frame.size() / 2);  // edges are lost, and what is farther than the sensor sees
    }
    EXPECT_NE(sumOfDepths(frames[0]), sumOfDepths(frames[1])) << "each has a seed of its own";
  }
}

TEST(FrameWithObjects, RefusesMoreThanHaveRoom) {
  EXPECT_THROW(frameWithObjects(0), std::invalid_argument);
  EXPECT_THROW(frameWithObjects(25), std::invalid_argument);
  EXPECT_GT(frameWithObjects(1).valid_count, 250000u);  // a table alone, less the edges of one object
}

}  // namespace
}  // namespace bench_harness_test
