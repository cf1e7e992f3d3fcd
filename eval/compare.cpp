// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// compare: several methods on the same labelled clouds, scored alike; see --help.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "eval/data_sets.h"
#include "eval/dump.h"
#include "eval/line_writer.h"
#include "eval/score_json.h"
#include "eval/score_table.h"
#include "synthetic/sensors.h"

namespace {

namespace eval = primitect::eval;

struct Options {
  std::vector<std::string> sets = {"paper-mixed"};
  std::string seeds = "1:12";
  eval::Recipe recipe;
  std::vector<std::string> methods = {"truth", "default", "paper"};
  std::vector<int> algorithm_seeds = {0};  ///< 0: as the method says
  eval::Rules rules;
  bool own_distance = false;  ///< rules.max_distance instead of the set's
  int repeat = 1;
  std::string json, dump_folder;
  bool about = false;
};

struct SeedRange {
  std::uint64_t first = 1;
  std::uint64_t count = 1;
};

/// "FIRST:COUNT" or "SEED".
SeedRange parseSeeds(const std::string& text) {
  const auto number = [&text](const std::string& digits) {
    if (digits.empty() || digits.size() > 18 || digits.find_first_not_of("0123456789") != std::string::npos) {
      throw std::invalid_argument("--seeds " + text + ": must be SEED or FIRST:COUNT, whole numbers");
    }
    return std::stoull(digits);
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {number(text), 1};
  const SeedRange range{number(text.substr(0, colon)), number(text.substr(colon + 1))};
  if (range.count == 0) throw std::invalid_argument("--seeds " + text + ": COUNT must be at least 1");
  return range;
}

/// One of ours runs once for each algorithm seed, under one name and with one sum.
struct Contest {
  std::vector<std::string> names;
  std::vector<eval::Method> methods;
  std::map<std::string, eval::Totals> totals;
  int true_shapes = 0;
};

Contest contestOf(const Options& options) {
  Contest contest;
  for (const std::string& text : options.methods) {
    const std::string name = eval::makeMethod(text).name;
    if (!contest.totals.emplace(name, eval::Totals()).second) {
      throw std::invalid_argument("--method " + text + ": there are two methods called " + name);
    }
    contest.names.push_back(name);
    for (const int seed : options.algorithm_seeds) {
      contest.methods.push_back(eval::makeMethod(text, seed));
      if (!contest.methods.back().ours) break;
    }
  }
  return contest;
}

/// The methods take turns in who comes first, so that none always has the cache of another.
void runCloud(const Options& options, const eval::LabelledCloud& input, Contest& contest, eval::LineWriter& lines) {
  std::vector<eval::NamedResult> results;
  for (const eval::TrueShape& truth : input.truth) contest.true_shapes += truth.must ? 1 : 0;
  for (std::size_t k = 0; k < contest.methods.size(); ++k) {
    const eval::Method& method = contest.methods[(k + input.recipe.seed) % contest.methods.size()];
    const eval::Answer answer = method.run(input, options.repeat);
    const eval::CaseScore score = eval::scoreCase(input, answer.shapes);
    eval::addCase(contest.totals[method.name], score, answer);
    lines.write(eval::scoreLine(input, method, answer, score));
    const bool is_first_seed = method.algorithm_seed == 0 || method.algorithm_seed == options.algorithm_seeds.front();
    if (!options.dump_folder.empty() && is_first_seed) results.push_back({method.name, answer.shapes});
  }
  if (!options.dump_folder.empty()) eval::writeDump(input, results, options.dump_folder);
}

eval::Recipe recipeOf(const std::string& set, std::uint64_t seed, const Options& options) {
  eval::Recipe recipe = options.recipe;
  recipe.set = set;
  recipe.seed = seed;
  return recipe;
}

void printTable(const std::string& set, const Options& options, Contest& contest) {
  std::printf("%s, seeds %s, %s; %d true shapes\n%s\n", set.c_str(), options.seeds.c_str(),
              eval::describe(recipeOf(set, 0, options)).c_str(), contest.true_shapes, eval::tableHeading().c_str());
  for (const std::string& name : contest.names) {
    std::printf("%s\n", eval::tableLine(name, contest.totals[name]).c_str());
  }
  std::printf("\n");
  std::fflush(stdout);
}

void compareOn(const std::string& set, const Options& options, eval::LineWriter& lines) {
  Contest contest = contestOf(options);
  const SeedRange seeds = parseSeeds(options.seeds);
  for (std::uint64_t k = 0; k < seeds.count; ++k) {
    eval::LabelledCloud input = eval::makeLabelledCloud(recipeOf(set, seeds.first + k, options));
    const double distance_of_set = input.rules.max_distance;
    input.rules = options.rules;
    if (!options.own_distance) input.rules.max_distance = distance_of_set;
    runCloud(options, input, contest, lines);
  }
  if (!lines.toStandardOutput()) printTable(set, options, contest);
}

void declareOptions(CLI::App& app, Options& options) {
  app.add_option("--set", options.sets, "data sets, comma separated")
      ->delimiter(',')
      ->check(CLI::IsMember(eval::dataSetNames()));
  app.add_option("--seeds", options.seeds, "FIRST:COUNT or one seed")->capture_default_str();
  app.add_option("--sigma", options.recipe.sigma,
                 "noise in m: of the paper's and the small set the standard deviation, of the parts the half width");
  app.add_option("--noise-scale", options.recipe.noise_scale, "times the noise of the simulated depth sensor");
  app.add_option("--sensor", options.recipe.sensor, "kind of the simulated depth sensor")
      ->check(CLI::IsMember(primitect::synthetic::sensorNames()))
      ->capture_default_str();
  app.add_option("--blots", options.recipe.blots, "share of the depth frames' pixels that are lost in blots");
  app.add_option("--noise-grain", options.recipe.noise_grain, "px, odd: so many by so many pixels share that noise");
  app.add_option("--width", options.recipe.width, "columns of the depth frames, 4 : 3");
  app.add_option("--outliers", options.recipe.outliers, "share of points thrown anywhere into the bounding box");
  app.add_option("--keep", options.recipe.keep, "share of the points that is kept");
  app.add_option("--uneven", options.recipe.uneven,
                 "from one side of the cloud to the other this many times fewer points");
  app.add_option("--voxel", options.recipe.voxel,
                 "side in m of the cubes in which points are averaged, as by a voxel grid");
  app.add_flag("--list", options.recipe.listed, "the measured points alone, in their order, unorganized");
  app.add_flag("--shuffle", options.recipe.shuffle, "points in random order, unorganized");
  app.add_flag("--robot-frame", options.recipe.robot_frame, "points in a frame on the floor below the sensor, z up");
  app.add_option("--method", options.methods,
                 "truth, default, paper, its ablations b to e, a peer (see --about) or "
                 "NAME=preset:PRESET,parameter=value,without:STEP,...; repeatable")
      ->allow_extra_args(false);
  app.add_option("--algorithm-seeds", options.algorithm_seeds,
                 "seeds of our random draw, comma separated: each of ours runs with all of them")
      ->delimiter(',')
      ->check(CLI::Range(1, 2147483647));
  app.add_option("--repeat", options.repeat, "run this often on each cloud, the shortest time counts")
      ->check(CLI::Range(1, 1000));
  app.add_option("--json", options.json, "append a line of JSON for each cloud and method; - for standard output");
  app.add_option("--write", options.dump_folder, "write each cloud and what was found into this folder, for drawing")
      ->check(CLI::ExistingDirectory);
  app.add_option("--max-distance", options.rules.max_distance, "scoring: a point's distance to its shape, m")
      ->check(CLI::Range(1e-6, 1e6))
      ->each([&options](const std::string&) { options.own_distance = true; });
  app.add_option("--max-angle-deg", options.rules.max_angle_deg, "scoring: between its normal and the shape's")
      ->check(CLI::Range(0.0, 90.0));
  app.add_flag("--about", options.about, "only print how this program was built, as JSON");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs several methods on the same labelled clouds and scores them alike."};
  Options options;
  declareOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    if (options.about) {
      std::printf("%s\n", eval::aboutJson().c_str());
      return 0;
    }
    // All of them before the first one is measured.
    for (const std::string& set : options.sets) checkRecipe(recipeOf(set, 0, options));
    eval::LineWriter lines(options.json);
    for (const std::string& set : options.sets) compareOn(set, options, lines);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare: %s\n", error.what());
    return 1;
  }
  return 0;
}
