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
  /// Builds a tree of the valid points.
  explicit NeighborSearch(const Cloud& cloud);
  ~NeighborSearch();

  /// Cloud indices of the `count` valid points nearest to a valid point, that point itself among them.
  void nearest(const Cloud& cloud, std::uint32_t point, int count, List<std::uint32_t>& neighbors);

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace primitect
