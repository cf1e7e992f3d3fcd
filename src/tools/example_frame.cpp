// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The simulated camera's first frame, as a file.
#include "tools/example_frame.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "io/pcd_writer.h"
#include "io/png_image.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"
#include "tools/format.h"

namespace primitect::tools {
namespace {

constexpr std::uint64_t kSeed = 1;  // of the demo

std::vector<float> depthsOfExample(const synthetic::PinholeCamera& camera) {
  return synthetic::renderFrame(synthetic::tabletop(kSeed), camera, synthetic::cameraPose(0.0), {}, kSeed, 0).depth;
}

std::string writePcdOf(const std::string& path, const synthetic::PinholeCamera& camera) {
  Cloud cloud;
  synthetic::cloudFromDepth(depthsOfExample(camera), camera, DepthRange(), cloud);
  io::writePcd(path, cloud);
  return path;
}

std::string writeDepthsOf(const std::string& path, const synthetic::PinholeCamera& camera) {
  constexpr float kUnits = 1000.0f;  // in a metre
  io::DepthPixels image = {static_cast<std::uint32_t>(camera.width), static_cast<std::uint32_t>(camera.height), {}};
  for (const float depth : depthsOfExample(camera)) {
    image.values.push_back(std::isfinite(depth) ? static_cast<std::uint16_t>(std::lround(kUnits * depth)) : 0);
  }
  try {
    io::writeDepthPng(path, image);
  } catch (const io::PngError& error) {
    throw std::runtime_error(path + ": cannot be written (" + error.what() + ")");
  }
  return path + format(" --intrinsics %g,%g,%g,%g", camera.fx, camera.fy, camera.cx, camera.cy);
}

}  // namespace

std::string writeExample(const std::string& path) {
  const std::filesystem::path name(path);
  if (name.extension() != ".pcd" && name.extension() != ".png") {
    throw std::invalid_argument("--example: '" + path + "', expected a name that ends in .pcd or .png");
  }
  if (std::filesystem::exists(name)) throw std::invalid_argument("--example: " + path + " exists already");
  const synthetic::PinholeCamera camera;
  return name.extension() == ".pcd" ? writePcdOf(path, camera) : writeDepthsOf(path, camera);
}

}  // namespace primitect::tools
