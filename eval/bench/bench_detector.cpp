// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// bench_detector: cloud in memory to primitives, stage by stage; curves; other detectors on the same clouds.
// eval/speed runs it and tells what its cases mean.
#include <algorithm>
#include <string>

#include "eval/bench/harness.h"
#include "eval/bench/lazy_clouds.h"
#include "eval/bench/scenes.h"
#include "eval/peers/peers.h"
#include "io/point_files.h"
#include "primitect/detector.h"

namespace {

using namespace primitect;
using namespace primitect::bench;

constexpr std::size_t kPaperClouds = 3;  // they take seconds to make

/// For scenes that are neither cut in depth nor seen from the origin.
Params sceneParams(const std::string& preset) {
  Params params = presetParams(preset);
  params.min_depth = params.max_depth = 0.0;
  params.orient_normals = false;
  return params;
}

/// The frames as a node hands them on: cut at the default's depths.
std::vector<Cloud> cutFrames(const std::vector<Cloud>& frames) {
  const Params params;
  const DepthRange range{static_cast<float>(params.min_depth), static_cast<float>(params.max_depth)};
  std::vector<Cloud> cut(frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) io::cutAtDepth(frames[k], range, cut[k]);
  return cut;
}

SharedClouds frames(View view, int width, int height, std::size_t count) {
  return lazily([=] { return cutFrames(depthFrames(view, width, height, count)); });
}

/// A detector and what it said last.
struct Bout {
  explicit Bout(const Params& params) : detector(params) {}

  Detector detector;
  FrameClock* clock = nullptr;  ///< of the frame that runs
  double samples = 0.0, detections = 0.0;
};

Work detecting(const SharedClouds& clouds, const Params& params) {
  const auto bout = std::make_shared<Bout>(params);
  bout->detector.onStageDone([bout = bout.get()](const char* stage) { bout->clock->stageDone(stage); });
  const auto run = [bout, clouds](std::size_t frame, FrameClock& clock) {
    bout->clock = &clock;
    const Detections& found = bout->detector.detect(clouds->get()[frame]);
    bout->samples = found.samples;
    bout->detections = static_cast<double>(found.items.size());
  };
  const auto facts = [bout, clouds] {
    return Facts{{"points", static_cast<double>(clouds->get().front().size())},
                 {"samples", bout->samples},
                 {"detections", bout->detections}};
  };
  return {clouds->get().size(), run, facts};
}

Case detectCase(const std::string& name, const SharedClouds& clouds, const Params& params) {
  return {name, [clouds] { clouds->get(); }, [=] { return detecting(clouds, params); }};
}

/// Of a frame only the stage "vote" counts.
Case voteCase(const std::string& name, const SharedClouds& clouds, const Params& params) {
  const auto make_work = [=] {
    Work work = detecting(clouds, params);
    work.run = [detect = work.run](std::size_t frame, FrameClock& clock) {
      detect(frame, clock);
      for (const auto& [stage, milliseconds] : clock.stages()) {
        if (std::string(stage) == "vote") clock.end(milliseconds, milliseconds);
      }
    };
    return work;
  };
  return {name, [clouds] { clouds->get(); }, make_work};
}

eval::LabelledCloud peerInput(const Cloud& cloud, std::size_t index) {
  eval::LabelledCloud input;
  input.cloud = cloud;
  input.recipe.seed = kFirstSeed + index;
  return input;
}

/// Another detector; it times itself. Without warming up: it keeps nothing, and takes seconds.
Case peerCase(const std::string& peer, const SharedClouds& clouds) {
  const auto make_work = [=] {
    const auto shapes = std::make_shared<double>(0.0);
    const eval::Method method = *eval::makePeer(peer);
    const auto run = [=](std::size_t frame, FrameClock& clock) {
      const eval::Answer answer = method.run(peerInput(clouds->get()[frame], frame), 1);
      if (!answer.failure.empty()) throw std::runtime_error(peer + ": " + answer.failure);
      *shapes = static_cast<double>(answer.shapes.size());
      clock.end(answer.cpu_ms, answer.total_ms);
    };
    const auto facts = [=] {
      return Facts{{"points", static_cast<double>(clouds->get().front().size())}, {"detections", *shapes}};
    };
    return Work{clouds->get().size(), run, facts};
  };
  return {"peer/" + peer + "/paper", [clouds] { clouds->get(); }, make_work, false};
}

void addCurves(const SharedClouds& paper, std::vector<Case>& cases) {
  for (const std::size_t points : {10000, 30000, 100000, 300000, 1000000, 3000000, 10000000}) {
    const SharedClouds clouds = lazily([=] { return std::vector<Cloud>{paperCloudOf(points)}; });
    cases.push_back(detectCase("points/" + std::to_string(points), clouds, sceneParams("default")));
  }
  for (const int samples : {640, 1280, 2560, 5120, 10240}) {
    Params params = sceneParams("default");
    params.samples = samples;
    params.closer_samples = samples * 8 / 5;  // as many times as in the preset
    cases.push_back(detectCase("samples/" + std::to_string(samples), paper, params));
  }
  for (const int objects : {1, 2, 4, 8, 12, 16, 20, 24}) {
    const SharedClouds frame = lazily([=] { return cutFrames({frameWithObjects(objects)}); });
    cases.push_back(detectCase("objects/" + std::to_string(objects), frame, Params()));
  }
}

std::vector<Case> allCases(std::size_t inputs) {
  const SharedClouds paper = lazily([=] { return paperClouds(std::min(kPaperClouds, inputs)); });
  const SharedClouds one_paper = lazily([] { return paperClouds(1); });
  std::vector<Case> cases = {
      detectCase("detect/paper/default", paper, sceneParams("default")),
      detectCase("detect/paper/paper", paper, sceneParams("paper")),
      detectCase("detect/tabletop-640/default", frames(View::tabletop, 640, 480, inputs), Params()),
      detectCase("detect/tabletop-1280/default", frames(View::tabletop, 1280, 720, inputs), Params()),
      detectCase("detect/clutter-640/default", frames(View::clutter, 640, 480, inputs), Params()),
      detectCase("detect/wall-640/default", frames(View::wall, 640, 480, inputs), Params()),
      voteCase("vote/paper", one_paper, sceneParams("paper")),
  };
  addCurves(paper, cases);
  for (const std::string& peer : eval::peerNames()) {
    if (peer == "cgal" || peer == "pcl-sac") cases.push_back(peerCase(peer, paper));
  }
  return cases;
}

}  // namespace

int main(int argc, char** argv) { return runCases(argc, argv, allCases); }
