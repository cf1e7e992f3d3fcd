// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Stamps that go back: a bag begins again, or two sources publish on one topic.
#pragma once

#include <ros/time.h>

#include <array>
#include <cstdint>
#include <optional>

#include "steady_time.h"

namespace primitect::ros_layer {

class BackJumps {
 public:
  /// Each cloud; of those whose stamp goes back, after back().
  void cloud(const ros::Time& stamp);

  /// The stamp of the next cloud goes back, at this time by the clock. A bag that is played in a loop goes back to
  /// where it began, after many clouds: that is no sign of two sources, which go on. Of a loop of a few clouds it
  /// cannot be told.
  void back(const ros::Time& stamp, SteadyClock::time_point now);

  /// Stamps went back three times within 10 s, but for those of a bag in a loop.
  bool often(SteadyClock::time_point now) const;

  /// Of all of them, since the start.
  std::uint64_t count() const { return count_; }

 private:
  std::optional<ros::Time> begin_;  ///< stamp of the first cloud, or of the last that went back elsewhere
  std::uint64_t clouds_ = 0;        ///< since stamps went back
  std::uint64_t count_ = 0, suspicious_ = 0;
  std::array<SteadyClock::time_point, 3> last_ = {};  ///< suspicious ones, the latest first
};

}  // namespace primitect::ros_layer
