// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How many points lie on equal lengths of a tube; see thin_ends.h.
#include "core/thin_ends.h"

#include <algorithm>

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

/// What is left of these heights without thin ends, in pieces as short as their number allows.
FloatRange withoutThinEnds(const List<float>& heights) {
  constexpr std::size_t kMostPieces = 64, kPointsOfPiece = 16;  // fewer are a quarter by chance
  constexpr std::size_t kFewest = 4;                            // one in so many of what is usual
  FloatRange range(heights.data(), heights.size());
  const EqualPieces pieces(range, std::min(kMostPieces, heights.size() / kPointsOfPiece));
  if (!(pieces.length > 0.0f)) return range;
  List<std::size_t> counts(pieces.count, 0);
  for (const float height : heights) ++counts[pieces.at(height)];
  const std::size_t usual = usualCount(counts, heights.size());
  std::size_t first = 0, end = pieces.count;
  while (kFewest * counts[first] < usual) ++first;
  while (kFewest * counts[end - 1] < usual) --end;
  if (first > 0 || end < pieces.count) range.low = pieces.begin(first), range.high = pieces.begin(end);
  return range;
}

}  // namespace

SeenPoints withoutThinEnds(const Cylinder& cylinder, SeenPoints points) {
  constexpr std::size_t kFewestPoints = 64;
  constexpr int kTimes = 3;  // with ever shorter pieces
  for (int time = 0; time < kTimes && points.size() >= kFewestPoints; ++time) {
    List<float> heights(points.size());
    heightsAlong(cylinder.axis, points.x.data(), points.y.data(), points.z.data(), points.size(), heights.data());
    const FloatRange left = withoutThinEnds(heights);
    points.keep([&](std::size_t k) { return heights[k] >= left.low && heights[k] <= left.high; });
    if (points.size() == heights.size()) break;
  }
  return points;
}

}  // namespace primitect
