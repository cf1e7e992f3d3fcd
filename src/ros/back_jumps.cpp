// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Telling a loop from two sources; see back_jumps.h.
#include "back_jumps.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace primitect::ros_layer {

void BackJumps::cloud(const ros::Time& stamp) {
  if (!begin_) begin_ = stamp;
  ++clouds_;
}

void BackJumps::back(const ros::Time& stamp, SteadyClock::time_point now) {
  // Two sources take turns; of a loop some of the first clouds may be missed.
  constexpr std::uint64_t kManyClouds = 10;
  constexpr double kSamePlaceSeconds = 0.5;
  const bool loop = begin_ && clouds_ >= kManyClouds && std::abs(stamp.toSec() - begin_->toSec()) < kSamePlaceSeconds;
  ++count_;
  clouds_ = 0;
  if (loop) return;
  begin_ = stamp;
  ++suspicious_;
  std::rotate(last_.begin(), last_.end() - 1, last_.end());
  last_.front() = now;
}

bool BackJumps::often(SteadyClock::time_point now) const {
  constexpr std::chrono::seconds kWithin(10);
  return suspicious_ >= last_.size() && now - last_.back() < kWithin;
}

}  // namespace primitect::ros_layer
