// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Drawing the samples: spread over the cloud, seeded, ordered so that neighbours in space are neighbours in memory.
#pragma once

#include <cstdint>

#include "core/frame_memory.h"
#include "core/point_runs.h"
#include "core/samples.h"
#include "core/space_curve.h"
#include "primitect/cloud.h"

namespace primitect {

/// Draws a frame's samples, round by round; no point twice. Same cloud, rounds and seeds, same samples. Of each run of
/// points it knows which are free by a bit for each, so that a round costs as much as there are runs.
class Sampler {
 public:
  /// A new frame: all measured points of these runs are free. Both must stay.
  void begin(const Cloud& cloud, const PointRuns& runs);

  /// For the next draw only points with a bit in `wanted` are free, one word for each run; see PointRuns::measured.
  void keepTo(const List<std::uint64_t>& wanted);

  /// Draws min(count, free points) samples: one at random of each of count equal parts of the free points in the
  /// cloud's order, then sorted along a curve through space. Normals are left missing.
  void draw(std::size_t count, std::uint64_t seed, Samples& samples);

 private:
  void choose(std::size_t count, std::uint64_t seed);

  const Cloud* cloud_ = nullptr;
  const PointRuns* runs_ = nullptr;
  List<std::uint64_t> left_;  ///< measured and never drawn
  List<std::uint64_t> free_;
  SpaceCurve curve_;
  List<std::uint32_t> chosen_;  ///< indices of points in the cloud
  List<float> x_, y_, z_;       ///< theirs
};

/// The first samples of a cloud.
void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples);

/// Diagonal of the samples' bounding box (m), the paper's scene diameter d_s; 0 without samples.
double boundingBoxDiagonal(const Samples& samples);

}  // namespace primitect
