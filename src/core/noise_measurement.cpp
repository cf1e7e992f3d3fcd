// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Robust deviations of distances and normals; see noise_measurement.h.
#include "core/noise_measurement.h"

#include <algorithm>
#include <cmath>

#include "core/lower_quartile.h"
#include "core/proposal.h"

namespace primitect {
namespace {

/// 1.4826 times the median: the standard deviation of a normal distribution, whatever lies outside.
double robustDeviation(List<double>& magnitudes) { return 1.4826 * median(magnitudes); }

}  // namespace

std::optional<NoiseModel> measureNoise(const Samples& samples, const List<Candidate>& candidates,
                                       const ProposalRules& rules) {
  constexpr std::size_t kStrongest = 12;
  constexpr std::size_t kFewestInliers = 20;
  constexpr double kSmallestShare = 0.02;  // of the largest: exact data has float rounding
  const HeldGains nothing(samples.size(), 0.0f);
  List<double> distances, angles, shares, magnitudes, in_sigmas;
  List<std::uint32_t> set;
  for (std::size_t k = 0; k < std::min(candidates.size(), kStrongest); ++k) {
    Hypothesis hypothesis;
    gather(samples, nothing, candidates[k], rules, hypothesis, set);
    if (set.size() < kFewestInliers || !bestOfKinds(samples, nothing, set, rules, hypothesis)) continue;
    magnitudes.clear();
    for (const std::uint32_t i : set) magnitudes.push_back(std::abs(distance(hypothesis.shape, samples.point(i))));
    distances.push_back(robustDeviation(magnitudes));
    magnitudes.clear(), in_sigmas.clear();
    for (const std::uint32_t i : set) {
      const double cosine = std::abs(samples.normal(i).dot(normalAt(hypothesis.shape, samples.placeOfNormal(i))));
      magnitudes.push_back(std::acos(std::min(cosine, 1.0)));
      const double sigma = samples.normal_sigma[i];
      if (sigma > 0.0) in_sigmas.push_back(magnitudes.back() / sigma);
    }
    // The median of a Rayleigh distribution is 1.18 times its parameter, 1.4826 / 1.7456 of what robustDeviation gives.
    constexpr double kOfRayleigh = 1.0 / 1.7456;
    angles.push_back(kOfRayleigh * robustDeviation(magnitudes));
    if (in_sigmas.size() >= kFewestInliers) shares.push_back(kOfRayleigh * robustDeviation(in_sigmas));
  }
  if (distances.empty()) return std::nullopt;
  NoiseModel noise = rules.noise;
  noise.distance = std::clamp(lowerQuartile(distances), kSmallestShare * noise.distance, noise.distance);
  constexpr double kAngleDeviations = 4.0, kSmallestAngle = 0.12;  // rad: at edges normals are worse than elsewhere
  noise.angle = std::min(std::max(kAngleDeviations * lowerQuartile(angles), kSmallestAngle), noise.angle);
  if (!shares.empty()) noise.normals = std::max(1.0, lowerQuartile(shares));
  noise.most_turn = std::min(noise.most_turn, rules.noise.angle);
  return noise;
}

}  // namespace primitect
