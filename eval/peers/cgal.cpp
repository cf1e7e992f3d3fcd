// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Clouds to the program peer_cgal, shapes back; see cgal.h.
#include "eval/peers/cgal.h"

#include <pcl/io/pcd_io.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "eval/peers/answers.h"
#include "eval/peers/child_program.h"
#include "eval/peers/peer_cloud.h"
#include "eval/peers/points.h"
#include "eval/peers/scratch_folder.h"
#include "io/shape_json.h"

namespace primitect::eval {
namespace {

constexpr double kTimeout = 120.0;  // s, for one run

struct Settings {
  std::string samples = "0";     // 0: all points
  bool knows_the_noise = false;  // epsilon from the recipe instead of CGAL's default
  std::string kinds = "plane,sphere,cylinder,cone";
};

std::string programPath() { return toolsFolder() + "/peer_cgal"; }

std::optional<Settings> parseName(const std::string& name) {
  static const std::regex kPattern("cgal(?:-([1-9][0-9]{0,8})|(-3sigma))?(?::(plane|sphere|cylinder|cone)s)?");
  std::smatch parts;
  if (!std::regex_match(name, parts, kPattern)) return std::nullopt;
  Settings settings;
  if (parts[1].matched) settings.samples = parts[1];
  settings.knows_the_noise = parts[2].matched;
  if (parts[3].matched) settings.kinds = parts[3];
  return settings;
}

/// Three times the noise, m; on depth frames the noise at 1.5 m.
double epsilonFor(const LabelledCloud& input) {
  constexpr double kOnDepthFrames = 0.01;
  return input.from_sensor ? kOnDepthFrames * input.recipe.noise_scale : 3.0 * input.recipe.sigma;
}

std::vector<std::string> argumentsFor(const Settings& settings, const LabelledCloud& input, const std::string& file,
                                      int repeat) {
  std::vector<std::string> arguments = {file,
                                        "--kinds",
                                        settings.kinds,
                                        "--samples",
                                        settings.samples,
                                        "--seed",
                                        std::to_string(input.recipe.seed),
                                        "--repeat",
                                        std::to_string(repeat)};
  if (settings.knows_the_noise) {
    arguments.insert(arguments.end(), {"--epsilon", std::to_string(epsilonFor(input))});
  }
  return arguments;
}

void writeCloud(const Cloud& cloud, const std::vector<std::uint32_t>& points, const std::string& path) {
  pcl::PointCloud<pcl::PointNormal> pcl_cloud;
  for (const std::uint32_t i : points) {
    pcl_cloud.push_back({cloud.x[i], cloud.y[i], cloud.z[i], cloud.nx[i], cloud.ny[i], cloud.nz[i]});
  }
  pcl::PCDWriter().writeBinary(path, pcl_cloud);
}

Answer parseAnswer(const std::string& text) {
  const nlohmann::ordered_json result = nlohmann::ordered_json::parse(text);
  Answer answer;
  for (const nlohmann::ordered_json& shape : result.at("primitives")) answer.shapes.push_back(io::shapeFromJson(shape));
  answer.total_ms = result.at("total_ms").get<double>();
  answer.cpu_ms = result.at("cpu_ms").get<double>();
  answer.prepare_ms = result.at("prepare_ms").get<double>();
  return answer;
}

std::string failureText(const ProgramResult& result) {
  if (result.timed_out) return "peer_cgal took more than " + std::to_string(static_cast<int>(kTimeout)) + " s a run";
  if (!result.last_words.empty()) return result.last_words;
  return "peer_cgal ended with exit code " + std::to_string(result.exit_code);
}

Answer runCgal(const Settings& settings, const LabelledCloud& input, int repeat) {
  const Cloud& cloud = peerCloud(input);
  const std::vector<std::uint32_t> points = usablePoints(cloud);
  if (points.empty()) return failureOf("no point has a normal");
  try {
    const ScratchFolder folder;
    const std::string file = folder.path("cloud.pcd");
    writeCloud(cloud, points, file);
    const ProgramResult result =
        runProgram(programPath(), argumentsFor(settings, input, file, repeat), kTimeout * repeat);
    return result.exit_code == 0 ? parseAnswer(result.out) : failureOf(failureText(result));
  } catch (const std::exception& error) {
    return failureOf(std::string("peer_cgal: ") + error.what());
  }
}

}  // namespace

bool cgalBuilt() { return std::filesystem::exists(programPath()); }

std::optional<Method> makeCgal(const std::string& name) {
  const std::optional<Settings> settings = parseName(name);
  if (!settings) return std::nullopt;
  if (!cgalBuilt()) {
    throw std::runtime_error("method '" + name + "': " + programPath() +
                             " is missing; it is built where libcgal-dev is installed");
  }
  return Method{name, [settings = *settings](const LabelledCloud& input, int repeat) {
                  return runCgal(settings, input, repeat);
                }};
}

}  // namespace primitect::eval
