// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs of points that lie close together in a cloud, and the share of them that samples are drawn from.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/frame_memory.h"
#include "kernels/loops.h"
#include "primitect/cloud.h"

namespace primitect {

/// A place in the group of `size` runs that begins with `first`: as good as random, but the same every time. A fixed
/// one would be the same columns of every row where the size divides the runs of a row. Multiplicative hash (Knuth,
/// TAOCP 3, 6.4).
inline std::size_t placeInGroup(std::size_t first, std::size_t size) {
  return (static_cast<std::uint32_t>(first) * 2654435761u >> 16) % size;
}

/// Where runs lie in a cloud. In an image that they fill they are 16 pixels wide and 4 high: the ball around one is a
/// third as large as around 64 in a row, and near to fewer shapes and borders. Elsewhere they follow each other.
class RunLayout {
 public:
  RunLayout() = default;
  explicit RunLayout(const Cloud& cloud)
      : width_(cloud.organized() && cloud.width % kColumns == 0 && cloud.height % kRows == 0 ? cloud.width : 0) {}

  bool inImage() const { return width_ > 0; }
  /// From the first point of a run's row to that of the next.
  std::size_t stride() const { return width_ > 0 ? width_ : kColumns; }
  std::size_t firstPointOf(std::size_t run) const {
    if (width_ == 0) return run * kernels::kPointsPerRun;
    const std::size_t across = width_ / kColumns;
    return run / across * (kRows * width_) + run % across * kColumns;
  }
  std::size_t point(std::size_t run, std::size_t place) const {
    return firstPointOf(run) + place / kColumns * stride() + place % kColumns;
  }
  std::size_t runOf(std::size_t point) const {
    if (width_ == 0) return point / kernels::kPointsPerRun;
    return point / width_ / kRows * (width_ / kColumns) + point % width_ / kColumns;
  }

 private:
  static constexpr std::size_t kColumns = kernels::kPointsPerRow, kRows = kernels::kPointsPerRun / kColumns;
  std::size_t width_ = 0;  ///< of the image; 0: runs follow each other
};

/// Runs of kernels::kPointsPerRun points; the last one of a cloud may be shorter.
struct PointRuns {
  RunLayout layout;
  List<std::uint32_t> number;    ///< of each run in the cloud, rising
  List<float> x, y, z, radius;   ///< of balls around their points (m); radius -1: all are missing
  List<std::uint64_t> measured;  ///< a bit for each point of the run that is not missing, the first one lowest

  std::size_t size() const { return number.size(); }
};

/// The points that are left for the last run, filled up with missing ones.
struct LastRun {
  float x[kernels::kPointsPerRun], y[kernels::kPointsPerRun], z[kernels::kPointsPerRun];

  LastRun(const kernels::RunOfPoints& some, std::size_t count);
  kernels::RunOfPoints points() const { return {x, y, z, kernels::kPointsPerRow}; }
};

/// How many bits are set in each byte (sums over pairs, fours, bytes).
inline std::uint64_t bytesOf(std::uint64_t bits) {
  bits -= bits >> 1 & 0x5555555555555555u;
  bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
  return (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
}

/// How many bits are set.
inline std::uint32_t countOf(std::uint64_t bits) {
  return static_cast<std::uint32_t>(bytesOf(bits) * 0x0101010101010101u >> 56);
}

/// How many measured points of the runs have a bit in `wanted`, one word for each run.
inline std::size_t countWanted(const PointRuns& runs, const List<std::uint64_t>& wanted) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) count += countOf(runs.measured[k] & wanted[k]);
  return count;
}

inline std::size_t numberOfRuns(const Cloud& cloud) {
  return (cloud.size() + kernels::kPointsPerRun - 1) / kernels::kPointsPerRun;
}

/// All runs of a cloud.
void findRuns(const Cloud& cloud, PointRuns& all);

/// Those that samples are drawn from: all, or one of every so many (sixty-four at most), so that about 262144 measured
/// points are left; the others are not looked at. Which one of them is as good as random, but the same every time: a
/// few thousand samples are spread over the cloud as those of all points are.
void findSomeRuns(const Cloud& cloud, PointRuns& some);

}  // namespace primitect
