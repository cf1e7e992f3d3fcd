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

  /// Draws min(count, free points) samples: one at random of each of count equal runs of free points in the cloud's
  /// order, then sorted along a curve through space. Free are valid points without a label (null: all are without);
  /// those that were drawn before get one. Normals are left missing.
  void draw(const Cloud& cloud, std::vector<std::uint32_t>* labels, std::size_t count, std::uint64_t seed,
            Samples& samples);

 private:
  void countFree(const Cloud& cloud, const std::uint32_t* labels);
  void drawFree(const Cloud& cloud, const std::uint32_t* labels, std::size_t count, std::uint64_t seed);

  SpaceCurve curve_;
  std::vector<std::uint32_t> before_;                 ///< free points before every run of the cloud, and all of them
  std::vector<std::uint32_t> indices_, along_curve_;  ///< of points in the cloud
  std::vector<std::uint32_t> drawn_;                  ///< indices, in all rounds
};

/// The first samples of a cloud.
void drawSamples(const Cloud& cloud, std::size_t count, std::uint64_t seed, Samples& samples);

/// Diagonal of the samples' bounding box (m), the paper's scene diameter d_s; 0 without samples.
double boundingBoxDiagonal(const Samples& samples);

}  // namespace primitect
