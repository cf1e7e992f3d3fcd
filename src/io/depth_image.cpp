// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth PNGs to clouds.
#include "io/depth_image.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

#include "io/png_image.h"

namespace primitect::io {
namespace {

/// size: of the PNG, which the file may be longer than.
DepthPixels readPixels(const std::string& path, std::uint64_t size) {
  constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;
  std::vector<char> bytes(size);
  std::ifstream stream(path, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw FileError(path, "cannot be read to its end");
  try {
    return decodeDepthPng(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                          std::min(kMostPixels, mostDepthPixels(size)));
  } catch (const PngError& error) {
    throw FileError(path, error.what());
  }
}

}  // namespace

Cloud readDepthImage(const std::string& path, const FileHead& head, const DepthImageOptions& options) {
  if (!options.intrinsics) throw FileError(path, "a depth image needs intrinsics fx,fy,cx,cy");
  if (!(options.depth_scale > 0.0) || !std::isfinite(options.depth_scale)) {
    throw std::invalid_argument("depth_scale: must be above 0 m per unit");
  }
  const DepthPixels image = readPixels(path, checkDepthPng(path, head));

  const Intrinsics& lens = *options.intrinsics;
  const float scale = static_cast<float>(options.depth_scale);
  const float scale_x = static_cast<float>(options.depth_scale / lens.fx);
  const float scale_y = static_cast<float>(options.depth_scale / lens.fy);
  const float center_x = static_cast<float>(lens.cx), center_y = static_cast<float>(lens.cy);
  Cloud cloud;
  cloud.reset(image.width, image.height, false);
  std::size_t i = 0;
  for (std::uint32_t v = 0; v < image.height; ++v) {
    for (std::uint32_t u = 0; u < image.width; ++u, ++i) {
      const float depth = image.values[i];
      // 0 is missing and never becomes a point: z = 0 comes with x = y = 0.
      cloud.setPoint(i, (static_cast<float>(u) - center_x) * depth * scale_x,
                     (static_cast<float>(v) - center_y) * depth * scale_y, depth * scale, DepthRange{});
    }
  }
  return cloud;
}

}  // namespace primitect::io
