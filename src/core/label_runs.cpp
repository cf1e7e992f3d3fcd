// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Many labels at once; see label_runs.h.
#include "core/label_runs.h"

namespace primitect {
namespace {

/// Labels that are compared at once; of longer runs kManyLabels.
constexpr std::uint32_t kLabelsAtOnce = 16, kManyLabels = 64;

template <std::uint32_t count>
bool allAre(std::uint32_t label, const std::uint32_t* labels) {
  std::uint32_t different = 0;
  for (std::uint32_t k = 0; k < count; ++k) different |= labels[k] ^ label;
  return different == 0;
}

}  // namespace

List<LabelRun> labelRuns(const std::vector<std::uint32_t>& labels) {
  List<LabelRun> runs;
  runs.reserve(labels.size() / kLabelsAtOnce);
  const std::uint32_t count = static_cast<std::uint32_t>(labels.size());
  for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
    const std::uint32_t label = labels[begin];
    while (end + kManyLabels <= count && allAre<kManyLabels>(label, labels.data() + end)) end += kManyLabels;
    while (end + kLabelsAtOnce <= count && allAre<kLabelsAtOnce>(label, labels.data() + end)) end += kLabelsAtOnce;
    while (end < count && labels[end] == label) ++end;
    if (label > 0) runs.push_back({label, begin, end});
  }
  return runs;
}

}  // namespace primitect
