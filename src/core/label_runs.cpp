// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From one change to the next; see label_runs.h.
#include "core/label_runs.h"

#include "kernels/loops.h"

namespace primitect {

List<LabelRun> labelRuns(const std::vector<std::uint32_t>& labels) {
  constexpr std::uint32_t kAtOnce = kernels::kPointsPerRun;
  List<LabelRun> runs;
  runs.reserve(labels.size() / 16);
  std::uint32_t begin = 0;  // of the run that goes on
  const auto endAt = [&](std::uint32_t end) {
    if (labels[begin] > 0) runs.push_back({labels[begin], begin, end});
    begin = end;
  };
  const kernels::Loops& loops = kernels::loops();
  const auto count = static_cast<std::uint32_t>(labels.size());
  std::uint32_t first = 0;
  for (; first + kAtOnce < count; first += kAtOnce) {
    for (std::uint64_t changes = loops.changes(labels.data() + first); changes != 0; changes &= changes - 1) {
      endAt(first + static_cast<std::uint32_t>(__builtin_ctzll(changes)) + 1);
    }
  }
  for (; first + 1 < count; ++first) {
    if (labels[first] != labels[first + 1]) endAt(first + 1);
  }
  if (count > 0) endAt(count);
  return runs;
}

List<LabelRun> labelRunsAgain(const List<LabelRun>& runs, const List<bool>& changed,
                              const std::vector<std::uint32_t>& labels) {
  List<LabelRun> again;
  again.reserve(2 * runs.size());
  const auto append = [&again](const LabelRun& run) {
    if (!again.empty() && again.back().end == run.begin && again.back().label == run.label) {
      again.back().end = run.end;
    } else if (run.label > 0) {
      again.push_back(run);
    }
  };
  for (const LabelRun& run : runs) {
    if (!changed[run.label - 1]) {
      append(run);
      continue;
    }
    for (std::uint32_t begin = run.begin, end; begin < run.end; begin = end) {
      for (end = begin + 1; end < run.end && labels[end] == labels[begin]; ++end) {
      }
      append({labels[begin], begin, end});
    }
  }
  return again;
}

List<PixelBox> boxesOfLabels(const List<LabelRun>& runs, std::size_t count, std::uint32_t width) {
  List<PixelBox> boxes(count, {~0u, 0, ~0u, 0});
  for (const LabelRun& run : runs) {
    if (run.label > count) continue;
    PixelBox& box = boxes[run.label - 1];
    forRows(run, width, [&box](std::uint32_t row, std::uint32_t begin, std::uint32_t end) {
      box = {std::min(box.left, begin), std::max(box.right, end - 1), std::min(box.top, row),
             std::max(box.bottom, row)};
    });
  }
  return boxes;
}

}  // namespace primitect
