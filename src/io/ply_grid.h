// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The indices in the range grid of a PLY.
#pragma once

#include <cstdint>
#include <string>

#include "io/file_checks.h"

namespace primitect::io {

/// Vertices, and behind them a grid: a list of indices (uchar, int) for each of its cells.
struct PlyGrid {
  std::uint64_t begin = 0;  ///< of the vertices, bytes
  std::uint64_t vertices = 0;
  std::uint64_t vertex_bytes = 0;  ///< of each; not of text
  std::uint64_t cells = 0;
  bool text = false;
  bool big_endian = false;
};

/// Throws FileError where the grid names a vertex that there is not, or the file ends before it does.
void checkPlyGrid(const std::string& path, const PlyGrid& grid);

}  // namespace primitect::io
