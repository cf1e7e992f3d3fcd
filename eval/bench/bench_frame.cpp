// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// bench_frame: bytes of a PointCloud2 to the filled PrimitiveArray, as the nodelet does it, without topics or a master.
// eval/speed runs it and tells what its cases mean.
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "eval/bench/harness.h"
#include "eval/bench/lazy_clouds.h"
#include "eval/bench/scenes.h"
#include "ros/frame_pipeline.h"
#include "ros/synthetic_messages.h"

namespace {

using namespace primitect;
using namespace primitect::bench;
using ros_layer::floatField;
using Messages = std::vector<sensor_msgs::PointCloud2>;

constexpr std::size_t kPaperClouds = 3;  // they take seconds to make

/// As drivers send clouds: x y z and four bytes of padding; in 32 bytes also colour, or the normals if there are any.
sensor_msgs::PointCloud2 messageOf(const Cloud& cloud, std::uint32_t point_step) {
  constexpr std::uint32_t kSecondHalf = 16;
  sensor_msgs::PointCloud2 message;
  message.header.frame_id = "camera_depth_optical_frame";
  message.width = cloud.width;
  message.height = cloud.height;
  message.point_step = point_step;
  message.row_step = point_step * cloud.width;
  message.is_dense = false;
  message.fields = {floatField("x", 0), floatField("y", 4), floatField("z", 8)};
  if (cloud.hasNormals()) {
    for (const auto& [name, offset] : {std::pair("normal_x", 0), {"normal_y", 4}, {"normal_z", 8}}) {
      message.fields.push_back(floatField(name, kSecondHalf + offset));
    }
  } else if (point_step > kSecondHalf) {
    message.fields.push_back(floatField("rgb", kSecondHalf));
  }
  message.data.assign(cloud.size() * point_step, 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::uint8_t* const point = message.data.data() + i * point_step;
    const float position[3] = {cloud.x[i], cloud.y[i], cloud.z[i]};
    std::memcpy(point, position, sizeof position);
    if (!cloud.hasNormals()) continue;
    const float normal[3] = {cloud.nx[i], cloud.ny[i], cloud.nz[i]};
    std::memcpy(point + kSecondHalf, normal, sizeof normal);
  }
  return message;
}

class LazyMessages {
 public:
  LazyMessages(SharedClouds clouds, std::uint32_t point_step) : clouds_(std::move(clouds)), point_step_(point_step) {}

  const Messages& get() {
    if (!messages_.empty()) return messages_;
    for (const Cloud& cloud : clouds_->get()) messages_.push_back(messageOf(cloud, point_step_));
    return messages_;
  }

 private:
  SharedClouds clouds_;
  std::uint32_t point_step_;
  Messages messages_;
};

/// A pipeline and what it found last.
struct Bout {
  explicit Bout(const Params& params) : pipeline(params) {}

  ros_layer::FramePipeline pipeline;
  FrameClock* clock = nullptr;  ///< of the frame that runs
  double detections = 0.0;
};

Work processing(const std::shared_ptr<LazyMessages>& messages, const Params& params) {
  const auto bout = std::make_shared<Bout>(params);
  bout->pipeline.onStageDone([bout = bout.get()](const char* stage) { bout->clock->stageDone(stage); });
  const auto run = [bout, messages](std::size_t frame, FrameClock& clock) {
    bout->clock = &clock;
    bout->pipeline.times().begin();
    const PrimitiveArray& message = bout->pipeline.process(messages->get()[frame]);
    clock.stageDone("message");
    clock.end();
    bout->pipeline.times().end();
    bout->detections = static_cast<double>(message.primitives.size());
  };
  const auto facts = [bout, messages] {
    const sensor_msgs::PointCloud2& first = messages->get().front();
    return Facts{{"points", static_cast<double>(first.width) * first.height}, {"detections", bout->detections}};
  };
  return {messages->get().size(), run, facts};
}

Case frameCase(const std::string& name, const SharedClouds& clouds, std::uint32_t point_step, const Params& params) {
  const auto messages = std::make_shared<LazyMessages>(clouds, point_step);
  return {name, [=] { messages->get(); }, [=] { return processing(messages, params); }};
}

SharedClouds frames(View view, int width, int height, std::size_t count) {
  return lazily([=] { return depthFrames(view, width, height, count); });
}

/// About so many pixels, 4 : 3.
Case pixelsCase(int pixels) {
  const int width = static_cast<int>(std::lround(std::sqrt(pixels * 4.0 / 3.0)));
  const int height = static_cast<int>(std::lround(width * 0.75));
  return frameCase("pixels/" + std::to_string(pixels), frames(View::tabletop, width, height, 1), 16, Params());
}

Params sceneParams() {
  Params params;
  params.min_depth = params.max_depth = 0.0;
  params.orient_normals = false;
  return params;
}

std::vector<Case> allCases(std::size_t inputs) {
  const SharedClouds vga = frames(View::tabletop, 640, 480, inputs), hd = frames(View::tabletop, 1280, 720, inputs);
  std::vector<Case> cases = {
      frameCase("frame/paper/32", lazily([=] { return paperClouds(std::min(kPaperClouds, inputs)); }), 32,
                sceneParams()),
      frameCase("frame/tabletop-640/16", vga, 16, Params()),
      frameCase("frame/tabletop-640/32", vga, 32, Params()),
      frameCase("frame/tabletop-1280/16", hd, 16, Params()),
      frameCase("frame/tabletop-1280/32", hd, 32, Params()),
      frameCase("frame/clutter-640/16", frames(View::clutter, 640, 480, inputs), 16, Params()),
      frameCase("frame/wall-640/16", frames(View::wall, 640, 480, inputs), 16, Params()),
  };
  for (const int pixels : {10000, 30000, 100000, 300000, 1000000, 3000000, 10000000}) {
    cases.push_back(pixelsCase(pixels));
  }
  return cases;
}

}  // namespace

int main(int argc, char** argv) { return runCases(argc, argv, allCases); }
