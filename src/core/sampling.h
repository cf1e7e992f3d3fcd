// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Drawing the samples: spread over the cloud, seeded, ordered so that neighbours in space are neighbours in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "core/explained_points.h"
#include "core/samples.h"
#include "core/space_curve.h"
#include "primitect/cloud.h"

namespace primitect {

/// Draws a frame's samples, round by round; no point twice. Same cloud, rounds and seeds, same samples.
class Sampler {
 public:
  /// A new frame, of which nothing is drawn yet.
  void begin(const Cloud& cloud);

  /// Draws `count` valid points, evenly spread over all that are free in the cloud's order: not explained and not drawn
  /// before. All of them where there are fewer. Sorted along a curve through space; normals are left missing.
  void draw(const Cloud& cloud, const ExplainedPoints& explained, std::size_t count, std::uint64_t seed,
            Samples& samples);

 private:
  void findFree(const Cloud& cloud, const ExplainedPoints& explained, std::size_t count, std::uint64_t seed);
  void drawFrom(const Cloud& cloud, std::size_t runs, std::uint64_t seed);
  void keepFree(const Cloud& cloud, const ExplainedPoints& explained);
  void keepEvenly(std::size_t count);

  SpaceCurve curve_;
  std::vector<bool> drawn_;  ///< of every point
  bool any_drawn_ = false;
  std::vector<std::uint32_t> indices_, along_curve_;  ///< of points in the cloud
};

/// The first samples of a cloud.
void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples);

/// Diagonal of the samples' bounding box (m), the paper's scene diameter d_s; 0 without samples.
double boundingBoxDiagonal(const Samples& samples);

}  // namespace primitect
