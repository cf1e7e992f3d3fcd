// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth PNGs through OpenCV.
#include "io/depth_image.h"

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

namespace primitect::io {
namespace {

/// libpng prints errors to stderr whatever its caller wants; they are thrown here instead. For the whole process,
/// briefly.
class QuietStderr {
 public:
  QuietStderr() {
    std::fflush(stderr);
    saved_ = dup(STDERR_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    if (saved_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~QuietStderr() {
    std::fflush(stderr);
    if (saved_ < 0) return;
    dup2(saved_, STDERR_FILENO);
    close(saved_);
  }
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;

 private:
  int saved_ = -1;
};

cv::Mat readImage(const std::string& path) {
  const QuietStderr quiet;
  try {
    return cv::imread(path, cv::IMREAD_UNCHANGED);
  } catch (const std::exception&) {
    return {};  // reported like any other image that cannot be decoded
  }
}

}  // namespace

Cloud readDepthImage(const std::string& path, const FileHead& head, const DepthImageOptions& options) {
  if (!options.intrinsics) throw FileError(path, "a depth image needs intrinsics fx,fy,cx,cy");
  if (!(options.depth_scale > 0.0) || !std::isfinite(options.depth_scale)) {
    throw std::invalid_argument("depth_scale: must be above 0 m per unit");
  }
  checkDepthPngHead(path, head);
  const cv::Mat image = readImage(path);
  if (image.empty()) throw FileError(path, "broken or truncated PNG data");
  if (image.type() != CV_16UC1) throw FileError(path, "is not 16-bit with one channel");

  const Intrinsics& lens = *options.intrinsics;
  const float scale = static_cast<float>(options.depth_scale);
  const float scale_x = static_cast<float>(options.depth_scale / lens.fx);
  const float scale_y = static_cast<float>(options.depth_scale / lens.fy);
  const float center_x = static_cast<float>(lens.cx), center_y = static_cast<float>(lens.cy);
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(image.cols), static_cast<std::uint32_t>(image.rows), false);
  std::size_t i = 0;
  for (int v = 0; v < image.rows; ++v) {
    const std::uint16_t* row = image.ptr<std::uint16_t>(v);
    for (int u = 0; u < image.cols; ++u, ++i) {
      const float depth = row[u];
      // 0 is missing and never becomes a point: z = 0 comes with x = y = 0.
      cloud.setPoint(i, (u - center_x) * depth * scale_x, (v - center_y) * depth * scale_y, depth * scale,
                     DepthRange{});
    }
  }
  return cloud;
}

}  // namespace primitect::io
