// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// An order of points in which neighbours in space are near each other.
#pragma once

#include <array>
#include <cstdint>

#include "core/frame_memory.h"
#include "kernels/loops.h"

namespace primitect {

/// Sorts points along the Hilbert curve; its buffers are kept. Unlike the Z curve it never jumps: boxes around runs of
/// samples, eight or 64 to a run, are smaller.
class SpaceCurve {
 public:
  /// The order of these points: positions in the lists, along the curve; as they come within a cell. The cube around
  /// most of them is divided into cells; the few farther out fall into the outermost.
  const List<std::uint32_t>& order(const List<float>& x, const List<float>& y, const List<float>& z);

 private:
  struct Entry {
    std::uint32_t place, position;
  };

  kernels::CellCube cubeAround(const std::array<const List<float>*, 3>& fields);
  void sortByPlace();

  List<Entry> entries_, sorted_;
  List<float> some_;
  List<std::uint32_t> place_, order_;
};

}  // namespace primitect
