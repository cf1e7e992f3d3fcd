// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs cases under Google Benchmark and keeps the time of every single frame, which percentiles need.
#pragma once

#include <chrono>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace primitect::bench {

/// Processor time of this thread, ms. What is measured works in one thread and waits for nothing: on a machine that
/// does nothing else this is the time that passes, on a busy one it leaves the others out.
inline double threadCpuMs() {
  std::timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

inline double steadyMs() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The times of one frame. Takes nothing from the heap while the frame runs: that is counted.
class FrameClock {
 public:
  FrameClock() { stages_.reserve(kMostStages); }

  void begin() {
    stages_.clear();
    ended_ = false;
    wall_begin_ = steadyMs();
    cpu_begin_ = last_ = threadCpuMs();
  }

  /// The stage that began where the one before ended is done; one that runs several times has the sum.
  /// `stage` must outlive the frame.
  void stageDone(const char* stage) {
    const double now = threadCpuMs();
    add(stage, now - last_);
    last_ = now;
  }

  /// The frame is done; only the first call of a frame counts.
  void end() { end(threadCpuMs() - cpu_begin_, steadyMs() - wall_begin_); }

  /// The same for work that is timed elsewhere, such as in another process, ms.
  void end(double cpu_ms, double wall_ms) {
    if (ended_) return;
    ended_ = true;
    cpu_ms_ = cpu_ms;
    wall_ms_ = wall_ms;
  }

  double cpuMs() const { return cpu_ms_; }
  double wallMs() const { return wall_ms_; }
  const std::vector<std::pair<const char*, double>>& stages() const { return stages_; }

 private:
  static constexpr std::size_t kMostStages = 32;

  void add(const char* stage, double milliseconds) {
    for (auto& [name, sum] : stages_) {
      if (std::strcmp(name, stage) == 0) {
        sum += milliseconds;
        return;
      }
    }
    if (stages_.size() < kMostStages) stages_.emplace_back(stage, milliseconds);
  }

  std::vector<std::pair<const char*, double>> stages_;
  bool ended_ = false;
  double wall_begin_ = 0.0, cpu_begin_ = 0.0, last_ = 0.0;
  double cpu_ms_ = 0.0, wall_ms_ = 0.0;
};

using Facts = std::vector<std::pair<std::string, double>>;

/// What is done over and over.
struct Work {
  std::size_t frames = 1;                             ///< different inputs, which take turns
  std::function<void(std::size_t, FrameClock&)> run;  ///< the frame of this number, 0 to frames - 1
  std::function<Facts()> facts;                       ///< what is known after a run: points, detections, ...
};

/// Something to measure. Its input is made, and kept, apart from what works on it, so that memory can be told apart.
struct Case {
  std::string name;
  std::function<void()> make_input;
  std::function<Work()> make_work;
  bool warm_up = true;  ///< each input once, untimed, before the first measured one
};

/// The whole of main(): Google Benchmark's options and
///   --times FILE    the time of every frame and stage, allocations and facts, as JSON
///   --memory CASE   instead of times: peak memory of this case above that of its input, as JSON on standard output
///   --inputs N      at most so many different inputs of a case
/// make: the cases with at most so many inputs.
int runCases(int argc, char** argv, std::vector<Case> (*make)(std::size_t inputs));

}  // namespace primitect::bench
