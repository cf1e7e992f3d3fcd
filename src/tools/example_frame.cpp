// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The simulated camera's first frame, as a file.
#include "tools/example_frame.h"

#include <filesystem>
#include <stdexcept>

#include "io/file_checks.h"
#include "io/pcd_writer.h"
#include "io/png_image.h"
#include "io/point_files.h"
#include "synthetic/frame.h"
#include "synthetic/millimetres.h"
#include "synthetic/tabletop.h"
#include "tools/format.h"

namespace primitect::tools {
namespace {

constexpr std::uint64_t kSeed = 1;  // of the demo

std::vector<float> depthsOfExample(const synthetic::PinholeCamera& camera) {
  return synthetic::renderFrame(synthetic::tabletop(kSeed), camera, synthetic::cameraPose(0.0), {}, kSeed, 0).depth;
}

void writePcdOf(const std::string& path, const synthetic::PinholeCamera& camera) {
  Cloud cloud;
  synthetic::cloudFromDepth(depthsOfExample(camera), camera, DepthRange(), cloud);
  io::writePcd(path, cloud);
}

void writeDepthsOf(const std::string& path, const synthetic::PinholeCamera& camera) {
  io::DepthPixels image = {static_cast<std::uint32_t>(camera.width), static_cast<std::uint32_t>(camera.height), {}};
  for (const float depth : depthsOfExample(camera)) image.values.push_back(synthetic::millimetres(depth));
  try {
    io::writeDepthPng(path, image);
  } catch (const io::PngError& error) {
    throw std::runtime_error(path + ": cannot be written (" + error.what() + ")");
  }
}

/// For a shell.
std::string quoted(const std::string& path) {
  return path.find_first_of(" \t'\"$&;()<>|*?[]`\\") == std::string::npos ? path : "\"" + path + "\"";
}

}  // namespace

std::string writeExample(const std::string& path) {
  namespace fs = std::filesystem;
  const bool image = io::isDepthImage(path);
  if (!image && io::lowerExtension(path) != ".pcd") {
    throw std::invalid_argument("--example: '" + path + "', expected a name that ends in .pcd or .png");
  }
  if (fs::exists(fs::symlink_status(path))) throw std::invalid_argument("--example: " + path + " exists already");
  const synthetic::PinholeCamera camera;
  try {
    image ? writeDepthsOf(path, camera) : writePcdOf(path, camera);
  } catch (const std::exception&) {
    std::error_code ignored;
    fs::remove(path, ignored);  // a part of it
    throw;
  }
  const std::string lens = format(" --intrinsics %g,%g,%g,%g", camera.fx, camera.fy, camera.cx, camera.cy);
  const std::string picture = fs::path(path).stem().string() + "_found.png";
  return quoted(path) + (image ? lens : "") + " --picture " + quoted(picture);
}

}  // namespace primitect::tools
