// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Neighbours in the cloud that carry the same label.
#pragma once

#include <algorithm>
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

/// Calls use(row, begin, end) for the columns that a run has in each row of an image of this width.
template <class Use>
void forRows(const LabelRun& run, std::uint32_t width, const Use& use) {
  for (std::uint32_t begin = run.begin; begin < run.end;) {
    const std::uint32_t row = begin / width, end = std::min(run.end, (row + 1) * width);
    use(row, begin - row * width, end - row * width);
    begin = end;
  }
}

/// Rows and columns of an image, the last ones included.
struct PixelBox {
  std::uint32_t left, right, top, bottom;
};

/// The boxes around the points of each label, 1 to `count`, in an image of this width; left > right: it has none. Other
/// labels are left out.
List<PixelBox> boxesOfLabels(const List<LabelRun>& runs, std::size_t count, std::uint32_t width);

}  // namespace primitect
