// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From the bytes of a PointCloud2 to the filled message nothing is taken from the heap in frames that were seen.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "eval/bench/allocations.h"
#include "ros/frame_pipeline.h"
#include "ros/synthetic_messages.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"

namespace primitect::message_allocations_test {
namespace {

using ros_layer::FramePipeline;

/// 640 x 480.
std::vector<sensor_msgs::PointCloud2> tabletops(std::uint64_t first_seed, std::size_t count) {
  const synthetic::PinholeCamera camera;
  std::vector<sensor_msgs::PointCloud2> messages;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    const Eigen::Isometry3d pose = synthetic::cameraPose(static_cast<double>(seed));
    const synthetic::Frame frame =
        renderFrame(synthetic::tabletop(seed), camera, pose, synthetic::FrameParams(), seed, 0);
    std_msgs::Header header;
    header.frame_id = "camera_depth_optical_frame";
    messages.push_back(*ros_layer::depthCloud(header, frame.depth, camera));
  }
  return messages;
}

/// Not published(): what frames take must not decide on the effort of the next one.
void processAll(const std::vector<sensor_msgs::PointCloud2>& messages, FramePipeline& pipeline) {
  for (const sensor_msgs::PointCloud2& message : messages) {
    pipeline.times().begin();
    ASSERT_FALSE(pipeline.process(message).primitives.empty());
    pipeline.times().end();
  }
}

void expectNoAllocations(const Params& params) {
  if (!bench::canCountAllocations()) GTEST_SKIP() << "malloc cannot be replaced here";
  const std::vector<sensor_msgs::PointCloud2> messages = tabletops(1, 4);
  FramePipeline pipeline(params);
  for (int pass = 0; pass < 2; ++pass) processAll(messages, pipeline);
  bench::beginCounting();
  processAll(messages, pipeline);
  EXPECT_EQ(bench::endCounting().count, 0u);
}

TEST(MessageAllocations, AreNoneInFramesThatWereSeen) { expectNoAllocations(Params()); }

TEST(MessageAllocations, AreNoneWithABoundOnTheTime) {
  Params params;
  params.max_latency = 1.0;  // s
  expectNoAllocations(params);
}

}  // namespace
}  // namespace primitect::message_allocations_test
