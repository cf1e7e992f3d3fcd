// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Durations by the steady clock, which no simulated time and no jump can disturb.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace primitect::ros_layer {

using SteadyClock = std::chrono::steady_clock;

inline double secondsSince(SteadyClock::time_point begin) {
  return std::chrono::duration<double>(SteadyClock::now() - begin).count();
}

/// Lets something happen at most once a period.
class Throttle {
 public:
  explicit Throttle(double period_seconds) : period_(period_seconds) {}

  /// True the first time and then once a period.
  bool ready() {
    if (started_ && secondsSince(last_) < period_) return false;
    started_ = true;
    last_ = SteadyClock::now();
    return true;
  }

 private:
  double period_;
  bool started_ = false;
  SteadyClock::time_point last_;
};

/// Milliseconds of one stage.
struct StageSummary {
  std::string stage;
  double median, p95, max;
};

/// How long each stage took in the last frames.
class StageTimes {
 public:
  /// A frame begins now.
  void begin() {
    frame_.clear();
    frame_begin_ = stage_begin_ = SteadyClock::now();
  }

  /// Seconds since the frame began, also when it is done.
  double elapsed() const { return secondsSince(frame_begin_); }

  /// The stage that began where the one before ended is done.
  /// A stage that runs several times in a frame counts once, with the sum of its times.
  void stageDone(const char* stage);

  /// The frame is done; returns its seconds.
  double end();

  /// What was done since end(), as a stage that is no part of "total".
  void recordAfter(const char* stage);

  /// In the order in which the stages first ran, "total" last.
  std::vector<StageSummary> summaries() const;

  void clear() { stages_.clear(); }

 private:
  static constexpr std::size_t kFrames = 300;  // 10 s at 30 Hz

  struct Record {
    std::string stage;
    std::vector<double> milliseconds;  ///< the last kFrames of them, oldest overwritten first
    std::size_t next = 0;
  };

  struct Stage {
    std::string name;
    double seconds;
  };

  void record(const Stage& stage);

  std::vector<Record> stages_;
  std::vector<Stage> frame_;  ///< of the frame that runs
  SteadyClock::time_point frame_begin_, stage_begin_;
};

}  // namespace primitect::ros_layer
