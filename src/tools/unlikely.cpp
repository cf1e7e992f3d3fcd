// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The second search; see unlikely.h.
#include "tools/unlikely.h"

#include <cstddef>

#include "primitect/detector.h"

namespace primitect::tools {

Detections tooUnlikely(const DetectInput& input, const std::vector<std::uint32_t>& labels) {
  constexpr double kMostly = 0.5;
  Params params = input.params;
  params.min_confidence = 0.0;
  Detector detector(params);
  const Detections& found = detector.detect(input.cloud);
  std::vector<std::uint32_t> second;
  detector.label(input.cloud, second);
  std::vector<std::size_t> all(found.items.size(), 0), of_nothing(found.items.size(), 0);
  for (std::size_t i = 0; i < second.size(); ++i) {
    if (second[i] == 0) continue;
    ++all[second[i] - 1];
    of_nothing[second[i] - 1] += labels[i] == 0 ? 1 : 0;
  }
  Detections result = found;
  result.items.clear();
  for (std::size_t k = 0; k < found.items.size(); ++k) {
    const bool unlikely = found.items[k].confidence < static_cast<float>(input.params.min_confidence);
    const bool elsewhere = static_cast<double>(of_nothing[k]) >= kMostly * static_cast<double>(all[k]);
    if (unlikely && elsewhere) result.items.push_back(found.items[k]);
  }
  return result;
}

}  // namespace primitect::tools
