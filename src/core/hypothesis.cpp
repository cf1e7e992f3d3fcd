// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One pass over the samples for each kind; see hypothesis.h.
#include "core/hypothesis.h"

#include <algorithm>
#include <cmath>

#include "core/matchers.h"

namespace primitect {
namespace {

/// Up to twice the tolerance a sample counts, though against the shape from the tolerance on; never more than this.
constexpr float kLeastGain = -1.2f;
constexpr float kReach = 2.0f;

template <class Matcher>
double collect(const Matcher& match, float side, float widen, const Samples& samples, const HeldGains& held,
               std::vector<Support>& support) {
  /// What a normal at the noise's limit takes from the gain; distance takes 1 at its limit.
  constexpr float kNormalShare = 0.8f;
  /// Normals up to this many times the limit speak against the shape; farther ones belong to another surface.
  constexpr float kAngleReach = 2.5f, kOtherSurface = 0.6f;
  const float widest = widen * static_cast<float>(kInlierDeviations);
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Match m = match({samples.x[i], samples.y[i], samples.z[i]}, {samples.nx[i], samples.ny[i], samples.nz[i]});
    const float limit = widest * samples.sigma[i];
    const float share = m.distance / limit;
    // 1 - cos of an angle is half its square.
    const float turn = 2.0f * (1.0f - side * m.cosine);
    const float normal_limit = samples.normal_limit[i];
    const float farthest = std::min(kAngleReach * normal_limit, kOtherSurface);
    if (!(std::fabs(share) < kReach && turn < farthest * farthest)) continue;
    const float normal_loss = kNormalShare * turn / (normal_limit * normal_limit);
    const float gain = std::max(1.0f - share * share - normal_loss, kLeastGain);
    support.push_back({static_cast<std::uint32_t>(i), gain});
    if (gain > 0.0f || held[i] < kWellExplained) sum += gain;
  }
  return sum;
}

}  // namespace

double priceOf(Kind kind, double inliers) {
  constexpr int kParameters[] = {3, 4, 5, 6};
  constexpr double kPerInlier = 0.01;
  const int parameters = kParameters[static_cast<std::size_t>(kind)];
  return parameters * (std::log(std::max(inliers, 1.0)) / 9.0 + kPerInlier * inliers);
}

void evaluate(const Samples& samples, const HeldGains& held, double widen, Hypothesis& hypothesis) {
  hypothesis.support.clear();
  const float side = hypothesis.concave ? -1.0f : 1.0f;
  const double gain = std::visit(
      [&](const auto& shape) {
        return collect(matcherOf(shape), side, static_cast<float>(widen), samples, held, hypothesis.support);
      },
      hypothesis.shape);
  const auto inliers = std::count_if(hypothesis.support.begin(), hypothesis.support.end(),
                                     [](const Support& support) { return support.gain > 0.0f; });
  hypothesis.score = gain - priceOf(kindOf(hypothesis.shape), static_cast<double>(inliers));
}

void hold(const Hypothesis& hypothesis, HeldGains& held) {
  for (const Support& support : hypothesis.support) {
    held[support.sample] = std::max(held[support.sample], support.gain);
  }
}

void inliersOf(const Hypothesis& hypothesis, std::vector<std::uint32_t>& inliers) {
  inliers.clear();
  for (const Support& support : hypothesis.support) {
    if (support.gain > 0.0f) inliers.push_back(support.sample);
  }
}

}  // namespace primitect
