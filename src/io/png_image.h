// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth images from PNG and to it, pictures to PNG. A library of its own: what unpacks depth images needs no other
// file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace primitect::io {

/// One line: the cause, without the name of the file.
class PngError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// height rows of width values each, as they were stored: units of the camera, mostly mm; 0 = not measured.
struct DepthPixels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint16_t> values;
};

/// Of size bytes. Throws PngError where they are no PNG, one that is broken or truncated, has other pixels than single
/// numbers of 16 bits, or more than most_pixels of them.
DepthPixels decodeDepthPng(const std::uint8_t* bytes, std::size_t size, std::uint64_t most_pixels);

/// Throws PngError where the file cannot be written, std::invalid_argument where the image is empty or not as large as
/// it says.
void writeDepthPng(const std::string& path, const DepthPixels& image);

/// A picture of height rows, stride bytes apart, of width pixels with 8 bits for blue, green and red each. Throws
/// PngError where the file cannot be written.
void writePicturePng(const std::string& path, const std::uint8_t* bgr, std::uint32_t width, std::uint32_t height,
                     std::size_t stride);

}  // namespace primitect::io
