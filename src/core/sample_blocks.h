// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs of samples that are close together, so that a shape need only be compared with the runs that it comes near.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

#include "core/frame_memory.h"
#include "kernels/loops.h"

namespace primitect {

struct Samples;

struct SampleBlock {
  std::size_t index, begin, end;
};

class SampleBlocks {
 public:
  static constexpr std::size_t kSize = 64;

  std::size_t size() const { return begin_.size(); }
  void clear();

  /// Of all samples, whose tolerances are known.
  void build(const Samples& samples);

  /// Adds those of more samples, the first of which is number `offset` here.
  void append(const SampleBlocks& more, std::size_t offset);

  /// Whether samples of the block may be within the radius (m) of this point.
  bool reaches(const SampleBlock& block, const Eigen::Vector3f& point, float radius) const {
    const Eigen::Vector3f center(x_[block.index], y_[block.index], z_[block.index]);
    return (point - center).norm() <= radius_[block.index] + radius;
  }

  /// Calls use(block) for the runs with samples that may be within `widen` times their tolerance of the shape.
  template <class Use>
  void forNear(const kernels::FlatShape& shape, float widen, const Use& use) const {
    constexpr std::size_t kAtOnce = 64;
    float distance[kAtOnce];
    for (std::size_t first = 0; first < begin_.size(); first += kAtOnce) {
      const std::size_t count = std::min(kAtOnce, begin_.size() - first);
      kernels::loops().distances(shape, x_.data() + first, y_.data() + first, z_.data() + first, count, distance);
      for (std::size_t k = 0; k < count; ++k) {
        const float away = distance[k] < 0.0f ? -distance[k] : distance[k];
        const std::size_t block = first + k;
        // Distances to a surface differ by no more than the points are apart.
        if (away <= radius_[block] + widen * tolerance_[block]) use(SampleBlock{block, begin_[block], end_[block]});
      }
    }
  }

 private:
  List<std::size_t> begin_, end_;
  List<float> x_, y_, z_, radius_;  ///< of a sphere around the samples (m)
  List<float> tolerance_;           ///< the largest (m)
};

}  // namespace primitect
