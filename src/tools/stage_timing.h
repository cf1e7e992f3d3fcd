// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How long the stages of a detector take, measured from outside by the steady clock.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "io/report.h"
#include "primitect/detector.h"
#include "primitect/latency_governor.h"

namespace primitect::tools {

/// Milliseconds between calls.
class Stopwatch {
 public:
  /// Since the last lap.
  double elapsedMs() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - last_).count();
  }

  double lapMs() {
    const auto now = std::chrono::steady_clock::now();
    const double lap = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return lap;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Adds to the time of that stage, which comes last if it is new: a stage runs once in each round of a detection.
void addTime(io::Timing& timing, const std::string& stage, double milliseconds);

/// One run and its times: each stage once, all rounds together, in the order of their first run, then "total".
struct TimedRun {
  io::Timing timing_ms;
  const Detections& found;  ///< valid until the detector's next run
};

/// With a governor the frame gets the effort that it allows; null: all of it.
TimedRun timeDetection(Detector& detector, const Cloud& cloud, LatencyGovernor* governor = nullptr);

/// Minimum, median and maximum of each stage over several runs.
struct TimingSummary {
  io::Timing min_ms, median_ms, max_ms;
};

/// All runs have the same stages; at least one run.
TimingSummary summarize(const std::vector<io::Timing>& runs);

}  // namespace primitect::tools
