// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Outlines are part of the result and so no List: here their memory waits for the next plane.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "primitect/primitives.h"

namespace primitect {

class SpareOutlines {
 public:
  /// An empty one for a shape of this kind, with room for as many corners as any had so far.
  std::vector<Vec3> take(Kind kind) {
    std::vector<Vec3> outline;
    if (kind != Kind::plane) return outline;
    if (!spare_.empty()) {
      outline = std::move(spare_.back());
      spare_.pop_back();
    }
    outline.clear();
    outline.reserve(most_corners_);
    return outline;
  }

  /// Shortens the list and keeps the outlines of what goes.
  void shorten(std::vector<Detection>& detections, std::size_t count) {
    for (std::size_t k = count; k < detections.size(); ++k) {
      std::vector<Vec3>& outline = detections[k].extent.hull;
      most_corners_ = std::max(most_corners_, outline.size());
      if (outline.capacity() > 0) spare_.push_back(std::move(outline));
    }
    detections.resize(std::min(count, detections.size()));
  }

  /// Keeps those whose index is wanted, in their order.
  template <class Wanted>
  void keep(std::vector<Detection>& detections, const Wanted& wanted) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < detections.size(); ++k) {
      if (!wanted(k)) continue;
      if (k != kept) std::swap(detections[kept], detections[k]);
      ++kept;
    }
    shorten(detections, kept);
  }

 private:
  std::vector<std::vector<Vec3>> spare_;
  std::size_t most_corners_ = 64;  ///< with so many, most frames never see one that has more
};

}  // namespace primitect
