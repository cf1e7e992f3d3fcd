// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Our detector's configurations as methods; see methods.h.
#include "eval/methods.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "eval/peers/peers.h"
#include "primitect/detector.h"
#include "primitect/moved_image.h"
#include "primitect/transforms.h"

namespace primitect::eval {
namespace {

using Clock = std::chrono::steady_clock;

/// What differs from a preset.
struct Settings {
  std::vector<std::pair<std::string, std::string>> values;
  Steps left_out;
};

/// The paper's ablations: Drost*, and one feature switched off in turn.
const std::map<std::string, std::string> kNamed = {{"default", "preset:default"},
                                                   {"paper", "preset:paper"},
                                                   {"b", "preset:drost"},
                                                   {"c", "preset:paper,clustering=nms"},
                                                   {"d", "preset:paper,average_bins=false"},
                                                   {"e", "preset:paper,spread_votes=false"}};

/// One configuration, set up for depth frames and for scenes that are neither cut in depth nor seen from the origin.
struct Contestant {
  Detector for_frames, for_scenes;
};

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Detector detectorWith(const std::string& preset, const Settings& settings) {
  Params params = presetParams(preset);
  for (const auto& [name, value] : settings.values) setParamFromText(params, name, value);
  params.left_out = settings.left_out;
  return Detector(params);
}

/// "preset:NAME,parameter=value,without:STEP,..."
std::shared_ptr<Contestant> parseContestant(const std::string& text) {
  std::string preset = "default";
  Settings given, scene = {{{"min_depth", "0"}, {"max_depth", "0"}, {"orient_normals", "false"}}, {}};
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = part.find('=');
    if (part.rfind("preset:", 0) == 0) {
      preset = part.substr(7);
    } else if (part.rfind("without:", 0) == 0) {
      given.left_out.add(stepOf(part.substr(8)));
    } else if (equals != std::string::npos) {
      given.values.emplace_back(part.substr(0, equals), part.substr(equals + 1));
    } else {
      throw std::invalid_argument("'" + part + "' is neither preset:NAME nor parameter=value nor without:STEP");
    }
  }
  scene.values.insert(scene.values.end(), given.values.begin(), given.values.end());
  scene.left_out = given.left_out;
  return std::make_shared<Contestant>(Contestant{detectorWith(preset, given), detectorWith(preset, scene)});
}

/// A camera's list is searched as the node does: where the order of its points tells it, from where the camera was.
class Search {
 public:
  explicit Search(Detector& detector) : detector_(detector) {}

  const Detections& detect(const Cloud& cloud, bool from_camera) {
    searched_ = &cloud;
    if (!from_camera || cloud.organized()) return detector_.detect(cloud);
    const CameraSearch found = searchForCamera(cloud);
    if (!found.cloud_from_camera) return detector_.detect(cloud);
    searched_ = &moved_;
    moved_ = cloud;
    moved_.move(found.cloud_from_camera->inverse(), DepthRange());
    found_ = detector_.detect(moved_);
    transformDetections(*found.cloud_from_camera, found_);
    return found_;
  }

  /// Of the cloud given to the last detect(), which must still be there.
  void label(std::vector<std::uint32_t>& labels) const { detector_.label(*searched_, labels); }

 private:
  Detector& detector_;
  const Cloud* searched_ = nullptr;  ///< that one, or moved_
  Cloud moved_;
  Detections found_;
};

Answer detectTimed(Detector& detector, const LabelledCloud& input, int repeat) {
  Answer answer;
  double vote_ms = 0.0;
  answer.total_ms = answer.vote_ms = std::numeric_limits<double>::infinity();
  Clock::time_point stage_start;
  detector.onStageDone([&](const char* stage) {
    if (std::string(stage) == "vote") vote_ms += millisecondsSince(stage_start);
    stage_start = Clock::now();
  });
  Search search(detector);
  for (int k = 0; k < repeat; ++k) {
    const Clock::time_point start = stage_start = Clock::now();
    vote_ms = 0.0;
    const Detections& detections = search.detect(input.cloud, input.from_sensor);
    answer.total_ms = std::min(answer.total_ms, millisecondsSince(start));
    answer.vote_ms = std::min(answer.vote_ms, vote_ms);
    answer.detections = detections.items;
    if (detections.status != Status::ok) answer.failure = statusName(detections.status);
  }
  for (const Detection& detection : answer.detections) answer.shapes.push_back(detection.shape);
  search.label(answer.labels);
  detector.onStageDone(nullptr);
  return answer;
}

Method ours(const std::string& name, const std::string& configuration, int algorithm_seed) {
  const std::string seed = algorithm_seed > 0 ? ",seed=" + std::to_string(algorithm_seed) : "";
  const std::shared_ptr<Contestant> contestant = parseContestant(configuration + seed);
  const auto run = [contestant](const LabelledCloud& input, int repeat) {
    Detector& detector = input.from_sensor ? contestant->for_frames : contestant->for_scenes;
    return detectTimed(detector, input, repeat);
  };
  return {name, run, true, algorithm_seed};
}

/// The shapes that must be found handed in as a result: what the scoring itself costs.
Method truthItself() {
  const auto run = [](const LabelledCloud& input, int) {
    Answer answer;
    for (const TrueShape& truth : input.truth) {
      if (truth.must) answer.shapes.push_back(truth.shape);
    }
    return answer;
  };
  return {"truth", run};
}

}  // namespace

Method makeMethod(const std::string& text, int algorithm_seed) {
  if (text == "truth") return truthItself();
  if (const auto named = kNamed.find(text); named != kNamed.end()) {
    return ours(text, named->second, algorithm_seed);
  }
  if (std::optional<Method> peer = makePeer(text)) return *peer;
  const std::size_t name_end = text.find('=');
  if (name_end == std::string::npos || name_end == 0) {
    std::string known = "truth";
    for (const auto& [name, configuration] : kNamed) known += ", " + name;
    for (const std::string& name : peerNames()) known += ", " + name;
    throw std::invalid_argument("method '" + text + "': must be " + known + ", or NAME=preset:PRESET,parameter=value");
  }
  try {
    return ours(text.substr(0, name_end), text.substr(name_end + 1), algorithm_seed);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("method '" + text + "': " + error.what());
  }
}

}  // namespace primitect::eval
