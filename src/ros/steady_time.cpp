// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Rolling records of the stages' durations.
#include "steady_time.h"

#include <algorithm>
#include <cmath>

namespace primitect::ros_layer {
namespace {

constexpr const char* kTotal = "total";

/// The smallest value that is at least as large as this share of the sorted values.
double quantile(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

}  // namespace

void StageTimes::stageDone(const char* stage) {
  add(stage, secondsSince(stage_begin_));
  stage_begin_ = SteadyClock::now();
}

double StageTimes::end() {
  const double seconds = secondsSince(frame_begin_);
  add(kTotal, seconds);
  return seconds;
}

std::vector<StageSummary> StageTimes::summaries() const {
  std::vector<StageSummary> summaries;
  for (const Record& record : stages_) {
    std::vector<double> sorted = record.milliseconds;
    std::sort(sorted.begin(), sorted.end());
    summaries.push_back({record.stage, quantile(sorted, 0.5), quantile(sorted, 0.95), sorted.back()});
  }
  std::stable_partition(summaries.begin(), summaries.end(), [](const auto& s) { return s.stage != kTotal; });
  return summaries;
}

void StageTimes::add(const char* stage, double seconds) {
  auto record = std::find_if(stages_.begin(), stages_.end(), [stage](const Record& r) { return r.stage == stage; });
  if (record == stages_.end()) record = stages_.insert(stages_.end(), Record{stage, {}, 0});
  if (record->milliseconds.size() < kFrames) {
    record->milliseconds.push_back(1e3 * seconds);
  } else {
    record->milliseconds[record->next] = 1e3 * seconds;
  }
  record->next = (record->next + 1) % kFrames;
}

}  // namespace primitect::ros_layer
