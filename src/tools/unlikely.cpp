// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The searches after the first; see unlikely.h.
#include "tools/unlikely.h"

#include <algorithm>
#include <cstddef>

#include "primitect/detector.h"

namespace primitect::tools {
namespace {

/// What a search with other parameters finds mostly on points of which the first made nothing.
Detections foundElsewhere(const Cloud& cloud, const Params& params, const std::vector<std::uint32_t>& labels) {
  constexpr double kMostly = 0.5;
  Detector detector(params);
  const Detections& found = detector.detect(cloud);
  std::vector<std::uint32_t> now;
  detector.label(cloud, now);
  std::vector<std::size_t> all(found.items.size(), 0), of_nothing(found.items.size(), 0);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] == 0) continue;
    ++all[now[i] - 1];
    of_nothing[now[i] - 1] += labels[i] == 0 ? 1 : 0;
  }
  Detections result = found;
  result.items.clear();
  for (std::size_t k = 0; k < found.items.size(); ++k) {
    const bool elsewhere = static_cast<double>(of_nothing[k]) >= kMostly * static_cast<double>(all[k]);
    if (elsewhere) result.items.push_back(found.items[k]);
  }
  return result;
}

}  // namespace

Detections tooUnlikely(const DetectInput& input, const std::vector<std::uint32_t>& labels) {
  Params params = input.params;
  params.min_confidence = 0.0;
  Detections found = foundElsewhere(input.cloud, params, labels);
  const auto likely = [&input](const Detection& item) {
    return item.confidence >= static_cast<float>(input.params.min_confidence);
  };
  found.items.erase(std::remove_if(found.items.begin(), found.items.end(), likely), found.items.end());
  return found;
}

int fewestInliers(const Params& params) {
  constexpr int kFewest = 12;
  return std::min(params.min_inliers, kFewest);
}

Detections tooFew(const DetectInput& input, const std::vector<std::uint32_t>& labels) {
  Params params = input.params;
  params.min_inliers = fewestInliers(params);
  params.min_votes = 0.0;
  return foundElsewhere(input.cloud, params, labels);
}

}  // namespace primitect::tools
