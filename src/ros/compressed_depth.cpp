// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Twelve bytes of parameters and a PNG of 16 bits; see compressed_depth.h.
#include "compressed_depth.h"

#include <sensor_msgs/image_encodings.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>

namespace primitect::ros_layer {
namespace {

namespace encodings = sensor_msgs::image_encodings;

/// What stands before the PNG. Of metres v are stored as a / v + b, in whole numbers.
struct Parameters {
  std::int32_t kind;  ///< unused
  float a, b;
};
static_assert(sizeof(Parameters) == 12);

/// "32FC1; compressedDepth png" -> 32FC1; older ones have no word at the end.
std::string encodingOf(const std::string& format) {
  const std::string encoding = format.substr(0, format.find(';'));
  const bool packed = format.find("compressedDepth") != std::string::npos;
  if (!packed || (encoding != encodings::TYPE_16UC1 && encoding != encodings::TYPE_32FC1)) {
    throw std::runtime_error("the image's format is '" + format +
                             "', expected is '16UC1; compressedDepth png' or '32FC1; compressedDepth png'");
  }
  if (format.find("rvl") != std::string::npos || format.find("RVL") != std::string::npos) {
    throw std::runtime_error("the image's format is '" + format + "': of compressed depths only PNG is read, not RVL");
  }
  return encoding;
}

/// Of its beginning: a short file may claim to be an image that fills the memory.
std::uint64_t pixelsOf(const std::uint8_t* png, std::size_t size) {
  constexpr std::array<std::uint8_t, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  constexpr std::size_t kWidth = 16, kEnd = 24;  // two big-endian numbers of 32 bits
  if (size < kEnd || std::memcmp(png, kSignature.data(), kSignature.size()) != 0) {
    throw std::runtime_error("the compressed image holds no PNG after its twelve bytes of parameters");
  }
  const auto number = [png](std::size_t at) {
    return std::uint64_t{png[at]} << 24 | std::uint64_t{png[at + 1]} << 16 | std::uint64_t{png[at + 2]} << 8 |
           png[at + 3];
  };
  return number(kWidth) * number(kWidth + 4);
}

/// Of one channel with 16 bits.
cv::Mat decoded(const std::uint8_t* png, std::size_t size) {
  constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 24;  // as of clouds
  if (const std::uint64_t pixels = pixelsOf(png, size); pixels > kMostPixels) {
    throw std::runtime_error("the compressed image has " + std::to_string(pixels) + " pixels, expected are at most " +
                             std::to_string(kMostPixels));
  }
  const cv::Mat bytes(1, static_cast<int>(size), CV_8UC1, const_cast<std::uint8_t*>(png));
  cv::Mat image = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  if (image.empty()) throw std::runtime_error("the compressed image's PNG is broken");
  if (image.type() != CV_16UC1) throw std::runtime_error("the compressed image's PNG is not one of 16 bit depths");
  return image;
}

}  // namespace

sensor_msgs::ImagePtr unpackedDepth(const sensor_msgs::CompressedImage& packed) {
  const std::string encoding = encodingOf(packed.format);
  Parameters parameters = {};
  if (packed.data.size() < sizeof(parameters)) throw std::runtime_error("the compressed image has no data");
  std::memcpy(&parameters, packed.data.data(), sizeof(parameters));
  const cv::Mat stored = decoded(packed.data.data() + sizeof(parameters), packed.data.size() - sizeof(parameters));

  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->header = packed.header;
  image->encoding = encoding;
  image->width = static_cast<std::uint32_t>(stored.cols);
  image->height = static_cast<std::uint32_t>(stored.rows);
  const bool metres = encoding == encodings::TYPE_32FC1;
  if (metres && !(std::isfinite(parameters.a) && parameters.a > 0.0f && std::isfinite(parameters.b))) {
    throw std::runtime_error("the compressed image tells no parameters of its depths");
  }
  image->step = image->width * static_cast<std::uint32_t>(metres ? sizeof(float) : sizeof(std::uint16_t));
  image->data.resize(std::size_t{image->step} * image->height);
  for (int row = 0; row < stored.rows; ++row) {
    std::uint8_t* const to = image->data.data() + std::size_t{image->step} * static_cast<std::size_t>(row);
    const auto* const from = stored.ptr<std::uint16_t>(row);
    if (!metres) {
      std::memcpy(to, from, image->step);
      continue;
    }
    for (int column = 0; column < stored.cols; ++column) {
      const float inverse = static_cast<float>(from[column]) - parameters.b;
      const bool measured = from[column] != 0 && inverse > 0.0f;
      const float depth = measured ? parameters.a / inverse : std::numeric_limits<float>::quiet_NaN();
      std::memcpy(to + sizeof(float) * static_cast<std::size_t>(column), &depth, sizeof(float));
    }
  }
  return image;
}

}  // namespace primitect::ros_layer
