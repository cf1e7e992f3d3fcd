// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gaps between points along an axis; see axis_gap.h.
#include "core/axis_gap.h"

#include <algorithm>
#include <array>

#include "core/float_range.h"

namespace primitect {
namespace {

constexpr std::size_t kPieces = 16, kGap = 4;

/// Pieces that follow on each other, from `begin` to before `end`.
struct Part {
  std::size_t begin = 0, end = 0, points = 0;
};

/// What is left of the pieces: from the first part that is large enough to the last one.
Part withoutFarEnds(const std::array<std::size_t, kPieces>& counts, std::size_t all) {
  constexpr std::size_t kHardlyAny = 32;  // one in so many of what a piece holds in the mean: strays in a gap
  constexpr std::size_t kFew = 8;         // one in so many of what the largest part holds
  std::array<Part, kPieces> parts;
  std::size_t found = 0, since = kGap;  // pieces since the last one that holds more than hardly any
  for (std::size_t piece = 0; piece < kPieces; ++piece) {
    if (kHardlyAny * kPieces * counts[piece] <= all) {
      ++since;
      continue;
    }
    if (since >= kGap) parts[found++].begin = piece;
    Part& part = parts[found - 1];
    part.end = piece + 1, part.points += counts[piece];
    since = 0;
  }
  Part* const end = parts.data() + found;
  const auto fewer = [](const Part& a, const Part& b) { return a.points < b.points; };
  const std::size_t most = std::max_element(parts.data(), end, fewer)->points;
  const auto isLarge = [most](const Part& part) { return kFew * part.points >= most; };
  Part left = *std::find_if(parts.data(), end, isLarge);
  for (const Part* part = parts.data(); part != end; ++part) {
    if (isLarge(*part)) left.end = part->end;
  }
  // Few points right beside it are its own.
  if (left.begin < kGap) left.begin = 0;
  if (left.end + kGap > kPieces) left.end = kPieces;
  return left;
}

}  // namespace

SeenPoints withoutFarEnds(const Vec3& axis, SeenPoints points) {
  constexpr std::size_t kFewestPoints = 64;
  constexpr int kTimes = 3;  // a farther stray makes pieces too long to tell nearer ones
  for (int time = 0; time < kTimes && points.size() >= kFewestPoints; ++time) {
    const std::size_t count = points.size();
    List<float> heights(count);
    heightsAlong(axis, points.x.data(), points.y.data(), points.z.data(), count, heights.data());
    const EqualPieces pieces(FloatRange(heights.data(), count), kPieces);
    if (!(pieces.length > 0.0f)) break;
    std::array<std::size_t, kPieces> counts = {};
    for (const float height : heights) ++counts[pieces.at(height)];
    const Part left = withoutFarEnds(counts, count);
    if (left.begin == 0 && left.end == kPieces) break;
    points.keep([&](std::size_t k) {
      const std::size_t piece = pieces.at(heights[k]);
      return piece >= left.begin && piece < left.end;
    });
  }
  return points;
}

}  // namespace primitect
