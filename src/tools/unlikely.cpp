// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The searches after the first; see unlikely.h.
#include "tools/unlikely.h"

#include <algorithm>
#include <cstddef>

#include "primitect/detector.h"

namespace primitect::tools {
namespace {

/// What a search with other parameters finds mostly on points that carry no label yet. Those below this confidence
/// only, and faces by their place among these; their points are labelled.
Detections foundElsewhere(const Cloud& cloud, const Params& params, double below, std::vector<std::uint32_t>& labels) {
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
  std::vector<bool> elsewhere;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool mostly = static_cast<double>(of_nothing[k]) >= kMostly * static_cast<double>(all[k]);
    elsewhere.push_back(all[k] > 0 && mostly && found.items[k].confidence < static_cast<float>(below));
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] > 0 && elsewhere[now[i] - 1]) labels[i] = now[i];
  }
  Detections result = found;
  result.items.clear();
  std::vector<std::int32_t> places;
  for (std::size_t k = 0; k < all.size(); ++k) {
    places.push_back(elsewhere[k] ? static_cast<std::int32_t>(result.items.size()) : kNoFace);
    if (elsewhere[k]) result.items.push_back(found.items[k]);
  }
  for (Detection& item : result.items) {
    for (std::int32_t* face : {&item.extent.face_at_minus_z, &item.extent.face_at_plus_z}) {
      if (*face != kNoFace) *face = places[static_cast<std::size_t>(*face)];
    }
  }
  return result;
}

}  // namespace

Unreported searchUnreported(const DetectInput& input, bool hurried, std::vector<std::uint32_t> labels) {
  constexpr double kAny = 2.0;  // confidence: all are below
  Params doubtful = input.params, few = input.params;
  doubtful.min_confidence = 0.0;
  few.min_inliers = fewestInliers(input.params);
  few.min_votes = 0.0;
  Unreported unreported;
  if (hurried) unreported.late = foundElsewhere(input.cloud, input.params, kAny, labels);
  if (input.params.verify) {
    unreported.unlikely = foundElsewhere(input.cloud, doubtful, input.params.min_confidence, labels);
  }
  unreported.few_inliers = foundElsewhere(input.cloud, few, kAny, labels);
  return unreported;
}

int fewestInliers(const Params& params) { return std::min(params.min_inliers, kFewestInliers); }

}  // namespace primitect::tools
