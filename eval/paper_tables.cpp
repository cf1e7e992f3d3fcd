// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's tables: detectors of several configurations on the same scenes of its data set, scored alike.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "eval/score_table.h"
#include "eval/write_scene.h"
#include "primitect/detector.h"
#include "synthetic/paper_dataset.h"

namespace {

using namespace primitect;
using Clock = std::chrono::steady_clock;

const std::vector<std::string> kPaperConfigs = {"paper=preset:paper",
                                                "b=preset:drost",
                                                "c=preset:paper,clustering=nms",
                                                "d=preset:paper,average_bins=false",
                                                "e=preset:paper,spread_votes=false",
                                                "default=preset:default"};

struct Options {
  std::vector<std::string> kinds = {"spheres", "cylinders", "cones", "planes", "mixed"};
  int scenes = 12;
  std::uint64_t seed = 1;
  std::vector<double> sigmas = {0.01};
  double outliers = 0.0;
  std::vector<std::string> configs = kPaperConfigs;
  int repeat = 1;
  eval::Rules rules;
  std::string ply_folder;
};

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A detector with a name that sums up its scores.
struct Contestant {
  std::string name;
  Detector detector;
  eval::Totals totals;
};

/// "name=preset:paper,parameter=value,...": the scenes' clouds are not cut in depth and their normals are kept, unless
/// a parameter says otherwise. Throws std::invalid_argument naming what is wrong.
Contestant parseConfig(const std::string& text) {
  const std::size_t name_end = text.find('=');
  if (name_end == std::string::npos || name_end == 0) {
    throw std::invalid_argument("--config " + text + ": must be name=preset:NAME,parameter=value,...");
  }
  Params params;
  std::vector<std::pair<std::string, std::string>> settings = {
      {"min_depth", "0"}, {"max_depth", "0"}, {"orient_normals", "false"}};
  std::istringstream parts(text.substr(name_end + 1));
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = part.find('=');
    if (part.rfind("preset:", 0) == 0) {
      params = presetParams(part.substr(7));
    } else if (equals != std::string::npos) {
      settings.emplace_back(part.substr(0, equals), part.substr(equals + 1));
    } else {
      throw std::invalid_argument("--config " + text + ": '" + part + "' is neither preset:NAME nor parameter=value");
    }
  }
  for (const auto& [name, value] : settings) setParamFromText(params, name, value);
  return {text.substr(0, name_end), Detector(params), {}};
}

/// Detects repeat times, which gives the same shapes each time, and keeps the shortest times.
std::vector<Shape> detectTimed(Contestant& contestant, const Cloud& cloud, int repeat) {
  double vote_ms = 0.0, best_vote_ms = 1e9, best_total_ms = 1e9;
  Clock::time_point stage_start;
  contestant.detector.onStageDone([&](const char* stage) {
    if (std::string(stage) == "vote") vote_ms += millisecondsSince(stage_start);
    stage_start = Clock::now();
  });
  const Detections* detections = nullptr;
  for (int k = 0; k < repeat; ++k) {
    const Clock::time_point start = stage_start = Clock::now();
    vote_ms = 0.0;
    detections = &contestant.detector.detect(cloud);
    best_total_ms = std::min(best_total_ms, millisecondsSince(start));
    best_vote_ms = std::min(best_vote_ms, vote_ms);
  }
  contestant.detector.onStageDone(nullptr);
  contestant.totals.vote_ms.push_back(best_vote_ms);
  contestant.totals.total_ms.push_back(best_total_ms);
  std::vector<Shape> shapes;
  for (const Detection& detection : detections->items) shapes.push_back(detection.shape);
  return shapes;
}

void printTable(const Options& options, synthetic::SceneKind kind, double sigma) {
  std::vector<Contestant> contestants;
  for (const std::string& config : options.configs) contestants.push_back(parseConfig(config));
  eval::Totals truth;
  for (int k = 0; k < options.scenes; ++k) {
    std::fprintf(stderr, "\r%s %d/%d ", synthetic::sceneKindName(kind), k + 1, options.scenes);
    const synthetic::PaperScene scene = makePaperScene(kind, options.seed + k, sigma, options.outliers);
    eval::addScene(truth, scene, scene.truth, options.rules);
    for (Contestant& contestant : contestants) {
      const std::vector<Shape> found = detectTimed(contestant, scene.cloud, options.repeat);
      eval::addScene(contestant.totals, scene, found, options.rules);
    }
  }
  std::fprintf(stderr, "\r                    \r");
  std::printf("%s, sigma %.3f, outliers %.0f %%, %d scenes (seeds %llu to %llu), %d true objects\n%s\n",
              synthetic::sceneKindName(kind), sigma, 100.0 * options.outliers, options.scenes,
              static_cast<unsigned long long>(options.seed),
              static_cast<unsigned long long>(options.seed + options.scenes - 1), truth.truths,
              eval::tableHeading().c_str());
  std::printf("%s\n", eval::tableLine("truth itself", truth, sigma).c_str());
  for (const Contestant& contestant : contestants) {
    std::printf("%s\n", eval::tableLine(contestant.name, contestant.totals, sigma).c_str());
    const std::string published = eval::publishedLine(contestant.name, kind);
    if (!published.empty()) std::printf("%s\n", published.c_str());
  }
  std::printf("\n");
  std::fflush(stdout);
}

void writeScenes(const Options& options, synthetic::SceneKind kind, double sigma) {
  for (int k = 0; k < options.scenes; ++k) {
    char stem[64];
    std::snprintf(stem, sizeof stem, "/%s_%04llu_sigma%.3f", synthetic::sceneKindName(kind),
                  static_cast<unsigned long long>(options.seed + k), sigma);
    eval::writeScene(makePaperScene(kind, options.seed + k, sigma, options.outliers), options.ply_folder + stem);
    std::fprintf(stderr, "%s%s.ply\n", options.ply_folder.c_str(), stem);
  }
}

void declareOptions(CLI::App& app, Options& options) {
  app.add_option("--kinds", options.kinds, "kinds of scenes")->delimiter(',')->check(CLI::IsMember(options.kinds));
  app.add_option("--scenes", options.scenes, "scenes of each kind")->check(CLI::Range(1, 100000));
  app.add_option("--seed", options.seed, "seed of the first scene, the others follow");
  app.add_option("--sigma", options.sigmas, "noise in m, a table for each")
      ->delimiter(',')
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--outliers", options.outliers, "share of points thrown anywhere into the bounding box")
      ->check(CLI::Range(0.0, 0.99));
  app.add_option("--config", options.configs,
                 "name=preset:NAME,parameter=value,...; repeatable. Names paper, b, c, d, e get the published figures "
                 "beside them. Default: these five and the default preset")
      ->allow_extra_args(false);
  app.add_option("--repeat", options.repeat, "detect this often, the shortest times count")->check(CLI::Range(1, 1000));
  app.add_option("--max-distance", options.rules.max_distance, "scorer: a point's distance to its shape, m");
  app.add_option("--max-angle", options.rules.max_angle_deg, "scorer: a point's normal against its shape's, deg");
  app.add_option("--write-ply", options.ply_folder,
                 "write the scenes as PLY with normals and true shapes into this folder, and stop")
      ->check(CLI::ExistingDirectory);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Scores detector configurations on the paper's synthetic data set");
  Options options;
  declareOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    for (const double sigma : options.sigmas) {
      for (const std::string& name : options.kinds) {
        const synthetic::SceneKind kind = synthetic::sceneKindFromName(name);
        options.ply_folder.empty() ? printTable(options, kind, sigma) : writeScenes(options, kind, sigma);
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "paper_tables: %s\n", error.what());
    return 1;
  }
  return 0;
}
