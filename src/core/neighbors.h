// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours in a cloud, through PCL's kd-tree; its headers stay in the source file.
#pragma once

#include <cstdint>
#include <memory>

#include "core/frame_memory.h"
#include "primitect/cloud.h"

namespace primitect {

class NeighborSearch {
 public:
  /// Builds a tree of the valid points. Of those that lie exactly in one place, as many do where coordinates are rounded
  /// or an image was enlarged, the first one: the others tell nothing of the surface.
  explicit NeighborSearch(const Cloud& cloud);
  ~NeighborSearch();

  /// Cloud indices of valid points in the `count` places nearest to a valid point, its own among them.
  void nearest(const Cloud& cloud, std::uint32_t point, int count, List<std::uint32_t>& neighbors);

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace primitect
