// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The indices in the range grid of a PLY: PCL's reader goes wherever they point.
#include "io/ply_grid.h"

#include <fstream>
#include <string>

namespace primitect::io {
namespace {

[[noreturn]] void cutOff(const std::string& path) { throw FileError(path, "broken or truncated PLY data"); }

void checkIndex(const std::string& path, std::int64_t index, std::uint64_t vertices) {
  if (0 <= index && static_cast<std::uint64_t>(index) < vertices) return;
  throw FileError(path, "broken or truncated PLY data: range_grid names vertex " + std::to_string(index) + " of " +
                            std::to_string(vertices));
}

void checkText(const std::string& path, const PlyGrid& grid, std::ifstream& file) {
  std::string line;
  for (std::uint64_t i = 0; i < grid.vertices; ++i) {
    if (!std::getline(file, line)) cutOff(path);
  }
  for (std::uint64_t i = 0; i < grid.cells; ++i) {
    std::int64_t count = 0, index = 0;
    if (!(file >> count)) cutOff(path);
    for (; count > 0; --count) {
      if (!(file >> index)) cutOff(path);
      checkIndex(path, index, grid.vertices);
    }
  }
}

std::int32_t indexOf(const unsigned char (&bytes)[4], bool big_endian) {
  std::uint32_t index = 0;
  for (int k = 0; k < 4; ++k) index |= std::uint32_t{bytes[big_endian ? 3 - k : k]} << (8 * k);
  return static_cast<std::int32_t>(index);
}

void checkBytes(const std::string& path, const PlyGrid& grid, std::ifstream& file) {
  file.seekg(static_cast<std::streamoff>(grid.begin + grid.vertices * grid.vertex_bytes));
  for (std::uint64_t i = 0; i < grid.cells; ++i) {
    for (int count = file.get(); count != 0; --count) {
      unsigned char bytes[4];
      if (count < 0 || !file.read(reinterpret_cast<char*>(bytes), sizeof(bytes))) cutOff(path);
      checkIndex(path, indexOf(bytes, grid.big_endian), grid.vertices);
    }
  }
}

}  // namespace

void checkPlyGrid(const std::string& path, const PlyGrid& grid) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(grid.begin));
  if (!file) cutOff(path);
  grid.text ? checkText(path, grid, file) : checkBytes(path, grid, file);
}

}  // namespace primitect::io
