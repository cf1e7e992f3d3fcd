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
  const auto same = [stage](const Stage& s) { return s.name == stage; };
  auto found = std::find_if(frame_.begin(), frame_.end(), same);
  if (found == frame_.end()) found = frame_.insert(frame_.end(), Stage{stage, 0.0});
  found->seconds += secondsSince(stage_begin_);
  stage_begin_ = SteadyClock::now();
}

double StageTimes::end() {
  const double seconds = secondsSince(frame_begin_);
  for (const Stage& stage : frame_) record(stage);
  record({kTotal, seconds});
  frame_.clear();
  stage_begin_ = SteadyClock::now();
  return seconds;
}

void StageTimes::recordAfter(const char* stage) { record({stage, secondsSince(stage_begin_)}); }

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

void StageTimes::record(const Stage& stage) {
  const auto same = [&stage](const Record& r) { return r.stage == stage.name; };
  auto record = std::find_if(stages_.begin(), stages_.end(), same);
  if (record == stages_.end()) {
    record = stages_.insert(stages_.end(), Record{stage.name, {}, 0});
    record->milliseconds.reserve(kFrames);
  }
  if (record->milliseconds.size() < kFrames) {
    record->milliseconds.push_back(1e3 * stage.seconds);
  } else {
    record->milliseconds[record->next] = 1e3 * stage.seconds;
  }
  record->next = (record->next + 1) % kFrames;
}

}  // namespace primitect::ros_layer
