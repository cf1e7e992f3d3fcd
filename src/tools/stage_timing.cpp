// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Timing of single runs and statistics over several.
#include "tools/stage_timing.h"

#include <algorithm>

namespace primitect::tools {

void addTime(io::Timing& timing, const std::string& stage, double milliseconds) {
  const auto same = [&stage](const auto& entry) { return entry.first == stage; };
  const auto known = std::find_if(timing.begin(), timing.end(), same);
  if (known == timing.end()) {
    timing.emplace_back(stage, milliseconds);
  } else {
    known->second += milliseconds;
  }
}

TimedRun timeDetection(Detector& detector, const Cloud& cloud, LatencyGovernor* governor) {
  io::Timing timing;
  Stopwatch total, stage;
  detector.onStageDone([&](const char* name) { addTime(timing, name, stage.lapMs()); });
  Effort effort;
  if (governor) {
    governor->beginFrame();
    effort = {governor->share(), [&] { return governor->shareInTime(1e-3 * total.elapsedMs()); }};
  }
  total.lapMs();
  stage.lapMs();
  const Detections& found = detector.detect(cloud, effort);
  timing.emplace_back("total", total.lapMs());
  if (governor && found.status == Status::ok) governor->endFrame(1e-3 * timing.back().second);
  detector.onStageDone(nullptr);
  return {timing, found};
}

TimingSummary summarize(const std::vector<io::Timing>& runs) {
  TimingSummary summary;
  for (std::size_t stage = 0; stage < runs.front().size(); ++stage) {
    std::vector<double> times;
    for (const io::Timing& run : runs) times.push_back(run.at(stage).second);
    std::sort(times.begin(), times.end());
    const std::string& name = runs.front()[stage].first;
    const std::size_t half = times.size() / 2;
    const double median = times.size() % 2 == 1 ? times[half] : 0.5 * (times[half - 1] + times[half]);
    summary.min_ms.emplace_back(name, times.front());
    summary.median_ms.emplace_back(name, median);
    summary.max_ms.emplace_back(name, times.back());
  }
  return summary;
}

}  // namespace primitect::tools
