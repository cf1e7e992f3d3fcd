// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Steps and bends of the mean distance along the axis; see bent_ends.h.
#include "core/bent_ends.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/axis_extent.h"

namespace primitect {
namespace {

/// Of the whole length; at an end so many of them are looked at, of which the next part may be so many.
constexpr std::size_t kRingsAlong = 60, kMostTried = 24, kMost = 15;

constexpr std::size_t kMostEndPoints = 2039;  // prime: seldom in time with the rows of an image

/// Rings around the axis, from one end to the other.
struct Rings {
  std::array<double, kRingsAlong> count = {};      ///< points
  std::array<double, kRingsAlong> distances = {};  ///< their sum, in standard deviations of the noise

  Rings(const SomePoints<kMostEndPoints>& points, const PointNoise& noise, const Shape& shape, const Extent& extent) {
    constexpr std::size_t kRoom = SomePoints<kMostEndPoints>::kRoom;
    float distance[kRoom], sigma[kRoom], height[kRoom];
    const kernels::FlatShape flat = flattened(shape, points.origin);
    kernels::loops().distances(flat, points.x, points.y, points.z, points.filled(), distance);
    noise.at(points, sigma);
    const Vec3 axis = extent.rotation.col(2);
    heightsAlong(axis, points.x, points.y, points.z, points.count, height);
    const double length = extent.size.z(), low = axis.dot(extent.origin - points.origin) - 0.5 * length;
    for (std::size_t k = 0; k < points.count; ++k) {
      const double ring = (height[k] - low) / length * kRingsAlong;
      if (!(ring >= 0.0 && ring < kRingsAlong)) continue;
      count[static_cast<std::size_t>(ring)] += 1.0;
      distances[static_cast<std::size_t>(ring)] += distance[k] / sigma[k];
    }
  }

  void turnRound() {
    std::reverse(count.begin(), count.end());
    std::reverse(distances.begin(), distances.end());
  }

  /// The share of the points that lies in the rings [begin, end).
  double shareOf(std::size_t begin, std::size_t end) const {
    double all = 0.0, some = 0.0;
    for (std::size_t k = 0; k < kRingsAlong; ++k) all += count[k], some += k >= begin && k < end ? count[k] : 0.0;
    return some / all;
  }

  /// The mean distance where no next part is looked for.
  double middle() const {
    double points = 0.0, sum = 0.0;
    for (std::size_t k = kMostTried; k < kRingsAlong - kMostTried; ++k) points += count[k], sum += distances[k];
    return points > 0.0 ? sum / points : 0.0;
  }
};

/// How many of the first rings are of the next part: those from which on, towards the end, a line that leaves the
/// surface, or a step, explains most of the squares of the distances.
std::size_t bentRings(const Rings& rings) {
  // Standard deviations: that far the line is off at the end. Of points beside a step those beyond three are missing.
  constexpr double kLine = 2.0, kStep = 1.5;
  constexpr double kLeastGained = 70.0;  // squares: noise that is the same for some pixels around explains tens
  // Measured: stacked cans that pass for one gain .2 to .9 of it, bottles and recorded things two and more.
  constexpr double kTimesTheRest = 2.0;
  const double middle = rings.middle();
  const auto strays = [&](std::size_t k) { return rings.distances[k] - middle * rings.count[k]; };
  std::size_t bent = 0;
  double most = kLeastGained;
  const auto take = [&](double height, double least, double gained, std::size_t cut) {
    if (std::abs(height) > least && gained > most) most = gained, bent = cut;
  };
  double beyond = 0.0, off = 0.0;  // points before the cut; sum of how far they stray
  for (std::size_t cut = 1; cut <= kMostTried; ++cut) {
    beyond += rings.count[cut - 1], off += strays(cut - 1);
    if (!(beyond > 0.0)) continue;
    take(off / beyond, kStep, off * off / beyond, cut);
    double products = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < cut; ++k) {
      const double from_cut = static_cast<double>(cut - k) - 0.5;
      products += from_cut * strays(k), squares += from_cut * from_cut * rings.count[k];
    }
    take(products / squares * static_cast<double>(cut), kLine, products * products / squares, cut);
  }
  if (bent == 0 || bent > kMost) return 0;
  // Where the rest strays, too, from ring to ring, the shape does not fit at all.
  double rest = 0.0;
  for (std::size_t k = bent; k < kRingsAlong - kMost; ++k) {
    if (rings.count[k] > 0.0) rest += strays(k) * strays(k) / rings.count[k] - 1.0;
  }
  return most > kTimesTheRest * rest ? bent : 0;
}

}  // namespace

double endWhereItBends(const SeenPoints& points, const PointNoise& sigma, const Shape& shape, Extent& extent) {
  if (!hasAxis(kindOf(shape)) || points.empty() || !(extent.size.z() > 0.0)) return 1.0;
  Rings rings(SomePoints<kMostEndPoints>(points), sigma, shape, extent);
  const std::size_t low = bentRings(rings);
  rings.turnRound();
  const std::size_t high = bentRings(rings);
  if (low + high == 0) return 1.0;
  // A part is less than the whole: two rings with nothing between them are no ends of anything.
  constexpr double kLeast = 0.5;
  const double left = rings.shareOf(high, kRingsAlong - low);
  if (left < kLeast) return 1.0;
  const double ring = extent.size.z() / kRingsAlong;
  moveEnds(static_cast<double>(low) * ring, -static_cast<double>(high) * ring, shape, extent);
  return left;
}

}  // namespace primitect
