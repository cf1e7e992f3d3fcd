// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Drawing the samples: spread over the cloud, seeded, ordered so that neighbours in space are neighbours in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "core/samples.h"
#include "core/space_curve.h"
#include "primitect/cloud.h"

namespace primitect {

/// Draws a frame's samples, round by round; no point twice. Same cloud, rounds and seeds, same samples.
class Sampler {
 public:
  /// A new frame, of which nothing is drawn yet.
  void begin() { drawn_.clear(); }

  /// Looks for the free points of these runs (see point_runs.h): valid and without a label; null: all are without.
  /// Those that were drawn before get one.
  void findFree(const Cloud& cloud, const std::vector<std::uint32_t>& runs, std::vector<std::uint32_t>* labels);

  /// Draws min(count, free points) samples: one at random of each of count equal parts of the free points in the
  /// cloud's order, then sorted along a curve through space. Normals are left missing.
  void draw(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples);

 private:
  SpaceCurve curve_;
  std::vector<std::uint32_t> free_, chosen_, along_curve_;  ///< indices of points in the cloud
  std::vector<std::uint32_t> drawn_;                        ///< the same, in all rounds
};

/// The first samples of a cloud.
void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples);

/// Diagonal of the samples' bounding box (m), the paper's scene diameter d_s; 0 without samples.
double boundingBoxDiagonal(const Samples& samples);

}  // namespace primitect
