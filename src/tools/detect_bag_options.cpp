// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Options of `detect_bag`; those of the parameters come from their table.
#include "tools/detect_bag_options.h"

#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "tools/command_line.h"
#include "tools/param_options.h"

namespace primitect::tools {
namespace {

constexpr const char* kDescription =
    "Finds planes, spheres, cylinders and cones in every cloud of a recording, without a ROS\n"
    "master and as fast as it can, with the result that the node has for it.";

constexpr const char* kFooter =
    "\nSeveral BAGs are the parts of one recording, as rosbag record --split makes them.\n"
    "sensor_frame and target_frame are reached by the transforms of the recording, all known\n"
    "from its beginning.\n"
    "Parameters: the preset, then the --params file, then the options; --preset replaces the\n"
    "preset of the file.\n"
    "--json: a line for each cloud, an object with stamp, frame_id, status and primitives, in\n"
    "metres and radians.\n"
    "--pictures: PNGs, named by their place among the clouds; those not searched have none.\n"
    "--out: /detector/primitives and /detector/markers, to be played beside the recording.\n"
    "Exit code: 0 clouds were searched, others say why not, 1 none was, or a bag could not be\n"
    "read (or not all of it) or written, 2 the command line or a parameter is wrong.";

namespace fs = std::filesystem;

bool isSameFile(const std::string& one, const std::string& other) {
  std::error_code none_such;
  return fs::weakly_canonical(one) == fs::weakly_canonical(other) || fs::equivalent(one, other, none_such);
}

void refuseRepeated(const std::vector<std::string>& bags) {
  for (std::size_t k = 0; k < bags.size(); ++k) {
    for (std::size_t other = 0; other < k; ++other) {
      if (isSameFile(bags[k], bags[other])) throw std::invalid_argument(bags[k] + " is named twice");
    }
  }
}

/// A bag is written under another name first, and then takes the place of what has its own.
void checkOutputs(const DetectBagOptions& options) {
  const std::string &json = options.json, &out = options.job.output;
  std::vector<std::string> written;
  if (!json.empty() && json != "-") written.push_back(json);
  if (!out.empty()) written.insert(written.end(), {out, out + ".part"});
  for (const std::string& output : written) {
    for (const std::string& bag : options.job.bags) {
      if (isSameFile(output, bag)) throw std::invalid_argument(output + " is what is read, it would be overwritten");
    }
  }
  if (!json.empty() && !out.empty() && isSameFile(json, out)) {
    throw std::invalid_argument("--json and --out: " + out + " is the same file");
  }
  if (!out.empty() && out != "-" && fs::path(out).extension() != ".bag") {
    throw std::invalid_argument("--out: " + out + " gets a bag, expected is a name that ends in .bag");
  }
  const bool replaces_other = !out.empty() && fs::exists(out) && !fs::is_regular_file(out);
  if (out == "-" || replaces_other) throw std::invalid_argument("--out: " + out + " is no file, expected is one");
}

void checkPictures(const DetectBagOptions& options) {
  const std::string& folder = options.pictures;
  std::error_code none_such;
  if (fs::exists(folder, none_such) && !fs::is_directory(folder, none_such)) {
    throw std::invalid_argument("--pictures: " + folder + " is no folder, expected is one");
  }
  for (const std::string& file : {options.json, options.job.output}) {
    if (!file.empty() && isSameFile(folder, file)) {
      throw std::invalid_argument("--pictures: " + folder + " is a file that is written, expected is a folder");
    }
  }
}

void checkSeconds(const std::string& option, double seconds) {
  constexpr double kMost = 1e9;
  if (0.0 <= seconds && seconds <= kMost) return;
  throw std::invalid_argument(option + ": " + valueText(seconds) + ", allowed: 0 to " + valueText(kMost) + " s");
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
  app.add_option("--start", job.start, "leave out the first S seconds")->type_name("S");
  app.add_option("--duration", job.duration, "read S seconds; 0: all")->type_name("S");
  app.add_option("--json", options.json, "write what was found, a line for each cloud; - is standard output")
      ->type_name("FILE|-");
  app.add_option("--pictures", options.pictures, "draw clouds with what was found into a folder, made if missing")
      ->type_name("FOLDER");
  app.add_option("--out", job.output, "write primitives and markers as a bag")->type_name("FILE.bag");
  param_options.addTo(app, {"transform_patience"});
  if (!parseOrSay(app, argc, argv)) return std::nullopt;
  refuseEmpty(app, {"--topic", "--camera-info", "--json", "--pictures", "--out"}, "is a name");
  ParamLayers params;
  param_options.take(app, params);
  if (param_options.printWanted()) {
    std::cout << params.asYaml();
    return std::nullopt;
  }
  job.params = params.asSaid();
  checkParams(job.params);
  if (job.bags.empty()) throw std::invalid_argument("no BAG given (see --help)");
  checkSeconds("--start", job.start);
  checkSeconds("--duration", job.duration);
  refuseRepeated(job.bags);
  checkOutputs(options);
  if (!options.pictures.empty()) checkPictures(options);
  return options;
}

}  // namespace primitect::tools
