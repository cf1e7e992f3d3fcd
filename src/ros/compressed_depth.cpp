// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Twelve bytes of parameters and a PNG of 16 bits; see compressed_depth.h.
#include "compressed_depth.h"

#include <sensor_msgs/image_encodings.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "io/png_image.h"

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
  const bool known =
      encoding == encodings::TYPE_16UC1 || encoding == encodings::MONO16 || encoding == encodings::TYPE_32FC1;
  if (!packed || !known) {
    throw std::runtime_error("the image's format is '" + format +
                             "', expected is '16UC1; compressedDepth png' or '32FC1; compressedDepth png'");
  }
  if (format.find("rvl") != std::string::npos || format.find("RVL") != std::string::npos) {
    throw std::runtime_error("the image's format is '" + format + "': of compressed depths only PNG is read, not RVL");
  }
  return encoding;
}

io::DepthPixels decoded(const std::uint8_t* png, std::size_t size) {
  constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 24;  // as of clouds
  try {
    return io::decodeDepthPng(png, size, kMostPixels);
  } catch (const io::PngError& error) {
    throw std::runtime_error(std::string("the compressed image, behind its twelve bytes of parameters: ") +
                             error.what());
  }
}

}  // namespace

sensor_msgs::ImagePtr unpackedDepth(const sensor_msgs::CompressedImage& packed) {
  const std::string encoding = encodingOf(packed.format);
  Parameters parameters = {};
  if (packed.data.size() < sizeof(parameters)) throw std::runtime_error("the compressed image has no data");
  std::memcpy(&parameters, packed.data.data(), sizeof(parameters));
  const io::DepthPixels stored =
      decoded(packed.data.data() + sizeof(parameters), packed.data.size() - sizeof(parameters));

  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->header = packed.header;
  image->encoding = encoding;
  image->width = stored.width;
  image->height = stored.height;
  const bool metres = encoding == encodings::TYPE_32FC1;
  if (metres && !(std::isfinite(parameters.a) && parameters.a > 0.0f && std::isfinite(parameters.b))) {
    throw std::runtime_error("the compressed image tells no parameters of its depths");
  }
  image->step = image->width * static_cast<std::uint32_t>(metres ? sizeof(float) : sizeof(std::uint16_t));
  image->data.resize(std::size_t{image->step} * image->height);
  if (!metres) {
    std::memcpy(image->data.data(), stored.values.data(), image->data.size());
    return image;
  }
  std::uint8_t* to = image->data.data();
  for (const std::uint16_t value : stored.values) {
    const float inverse = static_cast<float>(value) - parameters.b;
    const bool measured = value != 0 && inverse > 0.0f;
    const float depth = measured ? parameters.a / inverse : std::numeric_limits<float>::quiet_NaN();
    std::memcpy(to, &depth, sizeof(depth));
    to += sizeof(depth);
  }
  return image;
}

}  // namespace primitect::ros_layer
