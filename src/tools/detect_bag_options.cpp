// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Options of `detect_bag`; those of the parameters come from their table.
#include "tools/detect_bag_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "tools/param_options.h"

namespace primitect::tools {
namespace {

constexpr const char* kDescription =
    "Finds planes, spheres, cylinders and cones in the clouds of a recorded bag, without a ROS master and as fast as "
    "it "
    "can:\n"
    "every cloud is searched, with the result that the node has for it.";

constexpr const char* kFooter =
    "\nSeveral BAGs are the parts of one recording, as rosbag record --split makes them.\n"
    "sensor_frame and target_frame are reached by the transforms that the recording holds, all known from its "
    "beginning.\n"
    "Parameters: the preset, then the --params file, then the options; --preset replaces the preset of the file.\n"
    "--json: a line for each cloud, an object with stamp, frame_id, status and primitives. Metres, radians.\n"
    "--out: /detector/primitives and /detector/markers; rosbag play BAG FILE.bag shows both in RViz.\n"
    "Exit code: 0 all clouds were searched or say why not, 1 a bag could not be read or written, 2 the command line or "
    "a\n"
    "parameter is wrong.";

void refuseOverwriting(const DetectBagOptions& options) {
  if (!options.json.empty() && options.json == options.job.output) {
    throw std::invalid_argument("--json and --out: " + options.json + " is the same file");
  }
  for (const std::string& output : {options.json, options.job.output}) {
    for (const std::string& bag : options.job.bags) {
      std::error_code none_such;
      if (output.empty() || !std::filesystem::equivalent(output, bag, none_such)) continue;
      throw std::invalid_argument(output + " is what is read, it would be overwritten");
    }
  }
}

}  // namespace

std::optional<DetectBagOptions> parseDetectBagOptions(int argc, char** argv) {
  DetectBagOptions options;
  ros_layer::BagJob& job = options.job;
  ParamOptions param_options;
  CLI::App app(kDescription, "detect_bag");
  app.footer(kFooter);
  app.get_formatter()->column_width(30);
  app.set_version_flag("--version", std::string("detect_bag (primitect) ") + PRIMITECT_VERSION);
  app.add_option("BAG", job.bags, "recorded bags")->type_name("");
  app.add_option("--topic", job.topic, "clouds or depth images; the only one there is need not be named")
      ->type_name("TOPIC");
  app.add_option("--camera-info", job.camera_info, "of depth images (camera_info beside them)")->type_name("TOPIC");
  app.add_option("--start", job.start, "leave out the first S seconds")->check(CLI::Range(0.0, 1e9))->type_name("S");
  app.add_option("--duration", job.duration, "read S seconds; 0: all")->check(CLI::Range(0.0, 1e9))->type_name("S");
  app.add_option("--json", options.json, "write what was found, a line for each cloud; - is standard output")
      ->type_name("FILE|-");
  app.add_option("--out", job.output, "write primitives and markers as a bag")->type_name("FILE.bag");
  param_options.addTo(app, {"transform_patience"});
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw std::invalid_argument(std::string(error.what()) + " (see --help)");
    app.exit(error);
    return std::nullopt;
  }
  ParamLayers params;
  param_options.take(app, params);
  if (param_options.printWanted()) {
    std::cout << params.asYaml();
    return std::nullopt;
  }
  job.params = params.asSaid();
  checkParams(job.params);
  if (job.bags.empty()) throw std::invalid_argument("no BAG given (see --help)");
  refuseOverwriting(options);
  return options;
}

}  // namespace primitect::tools
