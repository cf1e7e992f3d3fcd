// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Neighbours in the cloud that carry the same label.
#pragma once

#include <cstdint>
#include <vector>

#include "core/frame_memory.h"

namespace primitect {

/// Points [begin, end) of the same label.
struct LabelRun {
  std::uint32_t label, begin, end;
};

/// All runs of a label above 0, in the order of the points.
List<LabelRun> labelRuns(const std::vector<std::uint32_t>& labels);

/// The same where labels have changed since within the runs of some labels only: `changed` says of which ones, by the
/// label - 1.
List<LabelRun> labelRunsAgain(const List<LabelRun>& runs, const List<bool>& changed,
                              const std::vector<std::uint32_t>& labels);

}  // namespace primitect
