// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// PNGs to read, and what was written read again, by libpng's own short way. Link PNG::PNG.
#pragma once

#include <png.h>
#include <zlib.h>

#include <cstdint>
#include <fstream>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace primitect::test {

/// Of one channel or BGR, 8 or 16 bits each, rows without gaps; values of 16 bits are stored as they are.
inline std::vector<std::uint8_t> encodedPng(const cv::Mat& pixels) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<std::uint32_t>(pixels.cols), image.height = static_cast<std::uint32_t>(pixels.rows);
  if (pixels.channels() == 3) image.format |= PNG_FORMAT_BGR;
  if (pixels.depth() == CV_16U) image.format |= PNG_FORMAT_FLAG_LINEAR;
  png_alloc_size_t size = 0;
  if (png_image_write_get_memory_size(image, size, 0, pixels.data, 0, nullptr) == 0) {
    throw std::runtime_error(image.message);
  }
  std::vector<std::uint8_t> bytes(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data, 0, nullptr) == 0) {
    throw std::runtime_error(image.message);
  }
  return bytes;
}

inline void writePng(const std::string& path, const cv::Mat& pixels) {
  const std::vector<std::uint8_t> bytes = encodedPng(pixels);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// BGR, 8 bits each; empty where it cannot be read.
inline cv::Mat readPicture(const std::string& path) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
  image.format = PNG_FORMAT_BGR;
  cv::Mat pixels(static_cast<int>(image.height), static_cast<int>(image.width), CV_8UC3);
  return png_image_finish_read(&image, nullptr, pixels.data, 0, nullptr) != 0 ? pixels : cv::Mat();
}

inline void writeBigEndian(std::uint32_t number, std::uint8_t* to) {
  for (int k = 0; k < 4; ++k) to[k] = static_cast<std::uint8_t>(number >> (24 - 8 * k));
}

/// Gives the chunk whose length is at this place its right checksum. Returns where the next one begins; 0: there is
/// none.
inline std::size_t checksumChunk(std::vector<std::uint8_t>& png, std::size_t at) {
  constexpr std::size_t kName = 4, kData = 8, kAround = 12;  // length, name and checksum are four bytes each
  if (at + kAround > png.size()) return 0;
  std::size_t length = 0;
  for (std::size_t k = 0; k < kName; ++k) length = length << 8 | png[at + k];
  if (length > png.size() - at - kAround) return 0;
  const uLong sum = crc32(0, png.data() + at + kName, static_cast<uInt>(length + kData - kName));
  writeBigEndian(static_cast<std::uint32_t>(sum), png.data() + at + kData + length);
  return at + kAround + length;
}

/// The same PNG that claims to have so many pixels.
inline std::vector<std::uint8_t> claiming(std::vector<std::uint8_t> png, std::uint32_t width, std::uint32_t height) {
  constexpr std::size_t kHeader = 8, kWidth = 16, kHeight = 20;
  if (png.size() < kHeight + 4) throw std::invalid_argument("this is no PNG");
  writeBigEndian(width, png.data() + kWidth), writeBigEndian(height, png.data() + kHeight);
  checksumChunk(png, kHeader);
  return png;
}

}  // namespace primitect::test
