// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the detector counts for its diagnostics.
#include "ros/detector_diagnostics.h"

#include <gtest/gtest.h>

#include "cloud_messages.h"
#include "ros/frame_pipeline.h"

namespace primitect::detector_diagnostics_test {
namespace {

using namespace ros_layer;

std::uint64_t countOf(const FrameCounters& counters, Refusal refusal) {
  return counters.refused[static_cast<std::size_t>(refusal)];
}

PrimitiveArray messageWith(std::initializer_list<std::uint8_t> types) {
  PrimitiveArray message;
  for (const std::uint8_t type : types) {
    message.primitives.emplace_back();
    message.primitives.back().type = type;
  }
  return message;
}

TEST(FrameCounters, SumUpPrimitivesAndRefusalsOfAllFramesAndKeepTheLastOnes) {
  FrameCounters counters;
  Refusals refusals;
  refusals[Refusal::too_large] = 7;
  refusals[Refusal::unlikely] = 1;
  counters.count(messageWith({Primitive::PLANE, Primitive::CONE}), refusals);
  refusals[Refusal::too_large] = 5;
  refusals[Refusal::unlikely] = 0;
  counters.count(messageWith({Primitive::PLANE}), refusals);
  EXPECT_EQ(counters.by_kind[Primitive::PLANE], 2u);
  EXPECT_EQ(counters.last_by_kind[Primitive::CONE], 0u);
  EXPECT_EQ(countOf(counters, Refusal::too_large), 12u);
  EXPECT_EQ(countOf(counters, Refusal::unlikely), 1u);
  EXPECT_EQ(counters.last_refused[Refusal::too_large], 5u);
  EXPECT_EQ(counters.last_refused[Refusal::unlikely], 0u);
  EXPECT_EQ(countOf(counters, Refusal::few_inliers), 0u);
}

/// A wall of 40 x 30 points, 1 m away.
sensor_msgs::PointCloud2 wall() {
  sensor_msgs::PointCloud2 message = test::plainCloud(40, 30);
  for (std::uint32_t i = 0; i < 40 * 30; ++i) {
    const float column = static_cast<float>(i % 40), row = static_cast<float>(i / 40);
    test::put(message, i / 40, i % 40, 0, 0.02f * (column - 19.5f));
    test::put(message, i / 40, i % 40, 4, 0.02f * (row - 14.5f));
    test::put(message, i / 40, i % 40, 8, 1.0f);
  }
  return message;
}

Refusals refusalsOfWall(const Params& params) {
  FramePipeline pipeline(params);
  pipeline.times().begin();
  pipeline.process(wall());
  return pipeline.refusals();
}

TEST(Refusals, SayWhyAWallIsMissing) {
  Params params;
  EXPECT_EQ(refusalsOfWall(params)[Refusal::unlikely], 0u);
  params.min_confidence = 1.0;
  EXPECT_GT(refusalsOfWall(params)[Refusal::unlikely], 0u);
  params.min_confidence = 0.0;
  params.min_inliers = 100000;
  EXPECT_GT(refusalsOfWall(params)[Refusal::few_inliers], 0u);
}

}  // namespace
}  // namespace primitect::detector_diagnostics_test
