// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Looks at the head of a point file before a library reads it: PCL believes sizes that a broken file claims.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "io/sensor_pose.h"

namespace primitect::io {

/// One line: "path: cause".
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& path, const std::string& cause) : std::runtime_error(path + ": " + cause) {}
};

/// The first bytes of a file and its size.
struct FileHead {
  std::string bytes;
  std::uint64_t file_size = 0;
};

/// Throws FileError when there is no such file, when it is not a regular file, cannot be read or is empty.
FileHead readFileHead(const std::string& path);

/// The number of points that a PCD claims. Throws FileError when its header is incomplete, contradicts itself or claims
/// more than the file holds.
std::uint64_t checkPcdHead(const std::string& path, const FileHead& head);

/// What a checked head says of the sensor, as PCL means it; nothing where that is the identity or no pose. Writers do
/// not agree: some have x ahead, some tell a pose in a frame that is not that of the points.
std::optional<SensorPose> pcdViewpoint(const std::string& path, const FileHead& head);

/// The number of points that a PLY claims; throws as that of a PCD. Also refuses what PCL's reader gets wrong or
/// crashes on: properties named twice, colours that are not consecutive or have blue before red, a range grid that is
/// not num_cols * num_rows or names vertices that there are not.
std::uint64_t checkPlyHead(const std::string& path, const FileHead& head);

/// Lines of numbers that a text body must have; 0: any.
struct TextTable {
  std::uint64_t lines = 0;
  std::uint64_t words_per_line = 0;
};

/// Throws FileError naming the first word of a text body that is no number, or the line that is too short or too long.
/// PCL takes such a word for 0 or skips the line.
void checkAsciiBody(const std::string& path, std::uint64_t begin, const TextTable& table);

/// How many pixels of 16 bits a PNG of so many bytes can hold at most.
std::uint64_t mostDepthPixels(std::uint64_t bytes);

/// Where the PNG ends, in bytes: what follows is not its own. Throws FileError when the file is not a 16-bit,
/// one-channel PNG of a size that the file can hold, or ends too early.
std::uint64_t checkDepthPng(const std::string& path, const FileHead& head);

/// Of a name: ".pcd" of cloud.PCD.
std::string lowerExtension(const std::string& path);

}  // namespace primitect::io
