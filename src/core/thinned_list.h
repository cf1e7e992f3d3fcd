// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What shapes are measured on: of a large cloud without order a part that says as much.
#pragma once

#include <cstdint>

#include "core/frame_memory.h"
#include "core/point_runs.h"
#include "primitect/cloud.h"

namespace primitect {

/// Of one frame after the other; its buffers are kept.
class ThinnedList {
 public:
  /// Every so many-th of these runs of the cloud, as long as 131072 measured points are left. A cloud stays whole where
  /// this bound leaves no choice, and where its missing points have a pattern that would leave it less than half of
  /// what it should. It must stay until the next one.
  void begin(const Cloud& cloud, const PointRuns& some);

  /// All of it, however large.
  void keep(const Cloud& cloud);

  bool thinned() const { return cloud_ == &part_; }
  const Cloud& cloud() const { return *cloud_; }
  /// How many measured points of the whole cloud there are to one of these.
  double each() const { return each_; }

 private:
  double copy(const Cloud& whole, const PointRuns& some);
  void copyRuns(const Cloud& whole);

  const Cloud* cloud_ = nullptr;
  Cloud part_;
  List<std::uint32_t> left_;  ///< numbers of runs
  double each_ = 1.0;
};

}  // namespace primitect
