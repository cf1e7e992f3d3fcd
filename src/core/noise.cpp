// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The noise of every sample; see noise.h.
#include "core/noise.h"

#include <algorithm>

#include "core/samples.h"

namespace primitect {
namespace {

/// rad, what a normal may be off. What normals turn out to be off, in deviations of their own, goes up to six times
/// what their windows tell: where pixels share their noise those of tubes a metre away err by 5 deg, and what was
/// measured in rad, on the table before them, is less.
double mostTurn(const NoiseModel& noise, double normal_sigma) {
  const double known = kNormalDeviations * normal_sigma;
  return std::max({noise.angle, known, std::min(noise.normals * known, noise.most_turn)});
}

}  // namespace

void applyNoise(const NoiseModel& noise, Samples& samples) {
  /// What a normal at the noise's limit takes from the gain; distance takes 1 at its limit.
  constexpr double kNormalShare = 0.8;
  /// Normals up to this many times the limit speak against the shape; farther ones belong to another surface.
  constexpr double kAngleReach = 2.5, kOtherSurface = 0.6;
  /// Of depth cameras: with 2, faces a small step apart, as the covers of books side by side, speak against each other,
  /// and none is found. Elsewhere of what is found on machined parts 7 % less would be right with it (compare --set
  /// parts --seeds 2340:16).
  constexpr float kReachInDepth = 1.5f, kReach = 2.0f;
  samples.gain_reach = noise.ofDepthCamera() ? kReachInDepth : kReach;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double sigma = noise.at(samples.point(i));
    const double limit = mostTurn(noise, samples.normal_sigma[i]);
    const double farthest = std::min(kAngleReach * limit, kOtherSurface);
    samples.sigma[i] = static_cast<float>(sigma);
    samples.inverse_tolerance[i] = static_cast<float>(1.0 / (kInlierDeviations * sigma));
    // 1 - cos of an angle is half its square.
    samples.normal_loss[i] = static_cast<float>(2.0 * kNormalShare / (limit * limit));
    samples.farthest_turn[i] = static_cast<float>(0.5 * farthest * farthest);
  }
  samples.blocks.build(samples);
}

}  // namespace primitect
