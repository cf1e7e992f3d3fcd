// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How many points lie on equal lengths of a tube; see thin_ends.h.
#include "core/thin_ends.h"

#include <algorithm>
#include <utility>

#include "core/float_range.h"

namespace primitect {
namespace {

/// What the piece that holds the middle one of all points holds, with the pieces in the order of how many they hold.
std::size_t usualCount(List<std::size_t> counts, std::size_t all) {
  std::sort(counts.begin(), counts.end());
  std::size_t so_far = 0;
  for (const std::size_t count : counts) {
    so_far += count;
    if (2 * so_far >= all) return count;
  }
  return 0;
}

/// Those at heights between the two.
SeenPoints between(float low, float high, const List<float>& heights, const SeenPoints& points) {
  SeenPoints result;
  result.origin = points.origin;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!(heights[k] >= low && heights[k] <= high)) continue;
    result.x.push_back(points.x[k]), result.y.push_back(points.y[k]), result.z.push_back(points.z[k]);
  }
  return result;
}

/// Once: pieces are as long as all of it allows.
SeenPoints trimmed(const Cylinder& cylinder, const SeenPoints& points) {
  constexpr std::size_t kMostPieces = 64, kPointsOfPiece = 16;  // fewer are a quarter by chance
  constexpr std::size_t kFewest = 4;                            // one in so many of what is usual
  const Eigen::Vector3f axis = cylinder.axis.cast<float>();
  List<float> heights(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    heights[k] = axis.x() * points.x[k] + axis.y() * points.y[k] + axis.z() * points.z[k];
  }
  const FloatRange range(heights.data(), heights.size());
  const std::size_t pieces = std::min(kMostPieces, points.size() / kPointsOfPiece);
  const float piece = (range.high - range.low) / static_cast<float>(pieces);
  if (!(piece > 0.0f)) return points;
  List<std::size_t> counts(pieces, 0);
  for (const float height : heights) {
    ++counts[std::min(pieces - 1, static_cast<std::size_t>((height - range.low) / piece))];
  }
  const std::size_t usual = usualCount(counts, points.size());
  std::size_t first = 0, end = pieces;
  while (kFewest * counts[first] < usual) ++first;
  while (kFewest * counts[end - 1] < usual) --end;
  if (first == 0 && end == pieces) return points;
  const auto at = [&](std::size_t k) { return range.low + static_cast<float>(k) * piece; };
  return between(at(first), at(end), heights, points);
}

}  // namespace

SeenPoints withoutThinEnds(const Cylinder& cylinder, const SeenPoints& points) {
  constexpr std::size_t kFewestPoints = 64;
  constexpr int kTimes = 3;  // with ever shorter pieces
  SeenPoints result = points;
  for (int time = 0; time < kTimes && result.size() >= kFewestPoints; ++time) {
    SeenPoints shorter = trimmed(cylinder, result);
    if (shorter.size() == result.size()) break;
    result = std::move(shorter);
  }
  return result;
}

}  // namespace primitect
