// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Options of `detect`; those of the parameters come from their table.
#include "tools/detect_options.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>

#include "primitect/kernel_choice.h"
#include "tools/command_line.h"
#include "tools/example_frame.h"
#include "tools/param_options.h"

namespace primitect::tools {
namespace {

constexpr const char* kDescription =
    "Finds planes, spheres, cylinders and cones in point files (PCD, PLY) and 16-bit depth images (PNG).\n"
    "Organized clouds and depth images are cut at min_depth and max_depth, other clouds are not, and normals that a "
    "file\n"
    "brings are kept as they are, unless --params or an option says otherwise.";

constexpr const char* kFooter =
    "\nParameters: the preset, then the --params file, then the options; --preset replaces the preset of the file.\n"
    "Results: one FILE gives a JSON object, several an array of them in the same order. A directory (one that exists, "
    "or\n"
    "a name ending in '/') gets <name of FILE>.json, .ply or .png for each FILE. Metres, radians, times in ms; "
    "\"total\" is\n"
    "from points to primitives, \"read\" apart from it; with --repeat the times are medians.\n"
    "With --max_latency all runs of a call count as frames in a row, each bound to that \"total\": results then depend "
    "on\n"
    "the machine, \"samples\" tells how many were used. Without it the same points give the same result, on other\n"
    "processors but for rounding.\n"
    "Exit code: 0 all files were read (also when nothing was found), 1 a file could not be read or written (one line "
    "each\n"
    "on stderr), 2 the command line or a parameter is wrong.";

/// Raw texts, checked after parsing so that the messages name parameter, value and range.
struct RawOptions {
  std::string intrinsics, depth_scale, sensor, repeats, example;
  std::vector<std::string> left_out;
  bool print_kernels = false;
};

std::string stepList() {
  std::string list;
  for (const StepInfo& step : stepTable()) list += (list.empty() ? "" : ", ") + step.name;
  return list;
}

void addMainOptions(CLI::App& app, DetectOptions& options, RawOptions& raw) {
  app.add_option("FILE", options.files, "point files or depth images")->type_name("");
  app.add_option("--json", options.json, "write what was found as JSON; - is standard output")->type_name("FILE|DIR|-");
  app.add_option("--labels", options.labels, "write the points with colour and label of their shape as PLY")
      ->type_name("FILE|DIR");
  app.add_option("--picture", options.picture, "write a picture with outlines and names as PNG")->type_name("FILE|DIR");
  app.add_option("--intrinsics", raw.intrinsics, "of depth images, in pixels")->type_name("fx,fy,cx,cy");
  app.add_option("--depth-scale", raw.depth_scale, "metres per unit of depth images (0.001)")->type_name("M");
  app.add_option(
         "--sensor", raw.sensor,
         "where the camera was, for points in another frame than its own (a robot's, a map): position (m) and "
         "orientation of its optical frame (z ahead, x right, y down) in the frame of the file, as tf2_tools echo.py "
         "prints them; results are in the frame of the file")
      ->type_name("\"X Y Z QX QY QZ QW\"");
  app.add_flag(
      "--unlikely", options.unlikely,
      "also what was refused for its confidence, and what fewer samples or votes would make, where nothing else is: "
      "why is my object missing?");
  app.add_option("--without", raw.left_out, "leave out a step, to learn what it brings; repeatable: " + stepList())
      ->type_name("STEP")
      ->allow_extra_args(false);
  app.add_option("--example", raw.example,
                 "write a simulated camera's view of a table, as PCD or depth PNG, say how to go on with it, and end")
      ->type_name("FILE");
  app.add_option("--repeat", raw.repeats, "detect N times in the same points: min, median, max of every stage")
      ->type_name("N");
  app.add_flag(
      "--kernels", raw.print_kernels,
      "print the voting kernels that this machine can run and the one in use, and end; the environment variable "
      "PRIMITECT_KERNELS names another one");
}

/// Writes the file. program: as the user called it.
std::string exampleText(const CLI::App& app, const std::string& path, const std::string& program) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() > 0 && option->get_name() != "--example") {
      throw std::invalid_argument("--example writes a file and ends: it takes no other FILE and no option");
    }
  }
  const std::string arguments = writeExample(path);
  return path + ": what the demo's simulated camera sees of its table. Next:\n\n    " + program + " " + arguments +
         "\n\n";
}

std::string kernelText() {
  std::string text = "available:";
  for (const std::string& name : kernelNames()) text += " " + name;
  return text + "\nin use: " + kernelInUse() + ", loops: " + loopsInUse() + "\n";
}

double positiveNumber(const std::string& name, const std::string& text, const std::string& unit) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value) || value <= 0.0) {
    throw std::invalid_argument(name + ": '" + text + "', allowed: a number above 0" + unit);
  }
  return value;
}

int repeatCount(const std::string& text) {
  constexpr int kMax = 1000000;
  const double value = positiveNumber("--repeat", text, "");
  if (value != std::floor(value) || value > kMax) {
    throw std::invalid_argument("--repeat: '" + text + "', allowed: a whole number from 1 to " + std::to_string(kMax));
  }
  return static_cast<int>(value);
}

void takeMainOptions(const CLI::App& app, const RawOptions& raw, DetectOptions& options) {
  if (app.count("--intrinsics")) options.depth_image.intrinsics = io::parseIntrinsics(raw.intrinsics);
  if (app.count("--depth-scale")) {
    options.depth_image.depth_scale = positiveNumber("--depth-scale", raw.depth_scale, " m per unit");
  }
  if (app.count("--sensor")) options.sensor = io::parseSensorPose(raw.sensor);
  for (const std::string& step : raw.left_out) options.left_out.add(stepOf(step));
  if (app.count("--repeat")) options.repeats = repeatCount(raw.repeats);
  refuseEmpty(app, {"--json", "--labels", "--picture"}, "a file or directory");
  if (options.labels == "-" || options.picture == "-") {
    throw std::invalid_argument("--labels and --picture write to a file or directory, not to '-'");
  }
}

void checkFiles(const DetectOptions& options) {
  if (options.files.empty())
    throw std::invalid_argument("no FILE given (see --help); --example table.pcd writes one to try");
  for (const std::string& file : options.files) {
    if (!io::isDepthImage(file)) continue;
    if (!options.depth_image.intrinsics) {
      throw std::invalid_argument(file + ": a depth image needs --intrinsics fx,fy,cx,cy");
    }
    if (options.sensor) {
      throw std::invalid_argument("--sensor: " + file + " is a depth image, its points are in the frame of the camera");
    }
  }
  if (options.depth_image.intrinsics && std::none_of(options.files.begin(), options.files.end(), io::isDepthImage)) {
    throw std::invalid_argument(
        "--intrinsics: none of the files is a depth image, point files have their own geometry");
  }
}

}  // namespace

std::optional<DetectOptions> parseDetectOptions(int argc, char** argv) {
  DetectOptions options;
  RawOptions raw;
  CLI::App app(kDescription, "detect");
  app.footer(kFooter);
  app.get_formatter()->column_width(30);
  app.set_version_flag("--version", std::string("detect (primitect) ") + PRIMITECT_VERSION);
  addMainOptions(app, options, raw);
  ParamOptions param_options;
  param_options.addTo(app, paramsOfGroup("node"));
  if (!parseOrSay(app, argc, argv)) return std::nullopt;
  param_options.take(app, options.params);
  if (app.count("--example")) {
    std::cout << exampleText(app, raw.example, argv[0]);
    return std::nullopt;
  }
  takeMainOptions(app, raw, options);
  if (param_options.printWanted()) {
    if (!raw.left_out.empty()) throw std::invalid_argument("--print-params prints parameters, --without is none");
    std::cout << options.params.asYaml();
    return std::nullopt;
  }
  if (raw.print_kernels) {
    std::cout << kernelText();
    return std::nullopt;
  }
  checkFiles(options);
  return options;
}

}  // namespace primitect::tools
