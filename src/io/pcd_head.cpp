// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The header of a PCD against the size of its file.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "io/file_checks.h"

namespace primitect::io {
namespace {

using Words = std::vector<std::string>;

/// Lines of the header by their first word, and where the data begins.
struct PcdHeader {
  std::map<std::string, Words> lines;
  std::uint64_t data_begin = 0;

  const Words& words(const std::string& path, const std::string& key) const {
    const auto found = lines.find(key);
    if (found == lines.end() || found->second.empty()) throw FileError(path, "broken PCD header: no " + key);
    return found->second;
  }
};

PcdHeader parsePcdHeader(const std::string& path, const std::string& bytes) {
  PcdHeader header;
  std::istringstream stream(bytes);
  std::string line;
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    std::string key, word;
    if (!(words >> key) || key[0] == '#') continue;
    if (key == "COLUMNS") key = "FIELDS";
    static const std::set<std::string> kKeys = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                                "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
    if (!kKeys.count(key)) throw FileError(path, "is not a PCD: its header has a line that no PCD has");
    if (header.lines.count(key)) throw FileError(path, "broken PCD header: " + key + " twice");
    Words& values = header.lines[key];
    while (words >> word) values.push_back(word);
    if (key != "DATA") continue;
    if (stream.eof()) throw FileError(path, "broken PCD: nothing after the header");
    header.data_begin = static_cast<std::uint64_t>(stream.tellg());
    return header;
  }
  throw FileError(path, "is not a PCD or its header is cut off: no DATA line");
}

std::uint64_t number(const std::string& path, const std::string& key, const std::string& word, std::uint64_t max) {
  const bool digits = !word.empty() && word.size() <= 18 && word.find_first_not_of("0123456789") == std::string::npos;
  const std::uint64_t value = digits ? std::stoull(word) : 0;
  if (!digits || value > max) {
    throw FileError(path, "broken PCD header: " + key + " " + word + ", expected 0 to " + std::to_string(max));
  }
  return value;
}

constexpr std::uint64_t kMaxPoints = 2147483647;  // PCL counts in int

std::uint64_t pointCount(const std::string& path, const PcdHeader& header) {
  const std::uint64_t width = number(path, "WIDTH", header.words(path, "WIDTH")[0], kMaxPoints);
  const std::uint64_t height = number(path, "HEIGHT", header.words(path, "HEIGHT")[0], kMaxPoints);
  if (width * height > kMaxPoints) throw FileError(path, "broken PCD header: WIDTH * HEIGHT is above 2147483647");
  const auto points = header.lines.find("POINTS");
  if (points != header.lines.end() &&
      number(path, "POINTS", header.words(path, "POINTS")[0], kMaxPoints) != width * height) {
    throw FileError(path, "broken PCD header: POINTS " + points->second[0] +
                              " is not WIDTH * HEIGHT = " + std::to_string(width * height));
  }
  return width * height;
}

/// Numbers of a point, and its bytes in a binary file.
struct PointSize {
  std::uint64_t values = 0;
  std::uint64_t bytes = 0;
};

PointSize pointSize(const std::string& path, const PcdHeader& header) {
  const Words& fields = header.words(path, "FIELDS");
  const Words& sizes = header.words(path, "SIZE");
  const Words& types = header.words(path, "TYPE");
  const Words counts = header.lines.count("COUNT") ? header.words(path, "COUNT") : Words(fields.size(), "1");
  if (sizes.size() != fields.size() || types.size() != fields.size() || counts.size() != fields.size()) {
    throw FileError(path, "broken PCD header: FIELDS, SIZE, TYPE and COUNT differ in length");
  }
  PointSize point;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool real = types[i] == "F" && (sizes[i] == "4" || sizes[i] == "8");
    const bool whole = (types[i] == "I" || types[i] == "U") &&
                       (sizes[i] == "1" || sizes[i] == "2" || sizes[i] == "4" || sizes[i] == "8");
    if (!real && !whole) {
      throw FileError(path, "broken PCD header: field " + fields[i] + " has TYPE " + types[i] + " SIZE " + sizes[i]);
    }
    if (fields[i] != "_" && std::count(fields.begin(), fields.end(), fields[i]) > 1) {
      throw FileError(path, "broken PCD header: field " + fields[i] + " twice");
    }
    const std::uint64_t count = number(path, "COUNT", counts[i], 65536);
    if (count == 0) throw FileError(path, "broken PCD header: COUNT 0");
    point.values += count;
    point.bytes += count * std::stoull(sizes[i]);
  }
  return point;
}

void refuseShort(const std::string& path, std::uint64_t points, std::uint64_t needed, std::uint64_t there) {
  if (needed <= there) return;
  throw FileError(path, "truncated PCD: " + std::to_string(points) + " points need at least " + std::to_string(needed) +
                            " bytes, the file has " + std::to_string(there));
}

std::uint32_t littleEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// PCL drops padding before it looks for what follows, which it then takes from the wrong place.
void refusePadding(const std::string& path, const PcdHeader& header) {
  const Words& fields = header.words(path, "FIELDS");
  if (std::count(fields.begin(), fields.end(), "_") == 0) return;
  throw FileError(path, "fields '_' in a compressed PCD are not supported; one with DATA binary may have them");
}

void checkCompressed(const std::string& path, const FileHead& head, std::uint64_t begin, std::uint64_t points,
                     std::uint64_t bytes) {
  refuseShort(path, points, 8, head.file_size - begin);
  if (begin + 8 > head.bytes.size()) throw FileError(path, "broken PCD: header too long");
  const std::uint64_t packed = littleEndian(head.bytes, begin), unpacked = littleEndian(head.bytes, begin + 4);
  refuseShort(path, points, packed, head.file_size - begin - 8);
  // LZF packs at most 264 bytes into three.
  if (unpacked != bytes || unpacked > packed * 88 + 264) {
    throw FileError(path, "broken PCD: " + std::to_string(points) + " points need " + std::to_string(bytes) +
                              " bytes, the compressed data claim " + std::to_string(unpacked) + " in " +
                              std::to_string(packed));
  }
}

}  // namespace

std::uint64_t checkPcdHead(const std::string& path, const FileHead& head) {
  const PcdHeader header = parsePcdHeader(path, head.bytes);
  const std::uint64_t points = pointCount(path, header);
  const PointSize point = pointSize(path, header);
  const std::uint64_t bytes = points * point.bytes;
  if (bytes >= 0xffffffffu) throw FileError(path, "PCDs of 4 GB and more are not supported");
  if (points == 0) return 0;
  const std::string& data = header.words(path, "DATA")[0];
  const std::uint64_t there = head.file_size - header.data_begin;
  if (data == "ascii") {
    refuseShort(path, points, points * point.values * 2 - 1, there);  // a digit and a blank each
    checkAsciiBody(path, header.data_begin, {points, point.values});
  } else if (data == "binary") {
    refuseShort(path, points, bytes, there);
  } else if (data == "binary_compressed") {
    refusePadding(path, header);
    checkCompressed(path, head, header.data_begin, points, bytes);
  } else {
    throw FileError(path, "broken PCD header: DATA " + data + ", expected ascii, binary or binary_compressed");
  }
  return points;
}

std::optional<SensorPose> pcdViewpoint(const std::string& path, const FileHead& head) {
  const PcdHeader header = parsePcdHeader(path, head.bytes);
  const auto line = header.lines.find("VIEWPOINT");
  if (line == header.lines.end() || line->second.size() != 7) return std::nullopt;
  const Words& w = line->second;  // tx ty tz qw qx qy qz
  try {
    const SensorPose pose =
        parseSensorPose(w[0] + " " + w[1] + " " + w[2] + " " + w[4] + " " + w[5] + " " + w[6] + " " + w[3]);
    if (pose.pointsFromSensor().isApprox(Eigen::Isometry3d::Identity(), 1e-6)) return std::nullopt;
    return pose;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace primitect::io
