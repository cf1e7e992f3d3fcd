// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Draws what tells much more often than what tells little, as for fits of a few equations to some of many.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/frame_memory.h"
#include "core/lower_quartile.h"
#include "core/random.h"

namespace primitect {

/// Always the same draws.
class WeightedDraw {
 public:
  /// tells: of each, how much it tells, in any unit, and less than 0 or not finite: nothing. At least one. What tells
  /// more than most counts for little more than these.
  explicit WeightedDraw(List<double> tells) : weights_(std::move(tells)) {
    for (double& weight : weights_) weight = std::isfinite(weight) && weight > 0.0 ? weight : 0.0;
    const double usual = usualOf(weights_);
    for (double& weight : weights_) {
      weight = usual > 0.0 ? weight / (weight + usual) : 1.0;
      sums_.push_back((sums_.empty() ? 0.0 : sums_.back()) + weight);
    }
  }

  /// Index of one.
  std::size_t next() {
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), random_.uniform() * sums_.back());
    return std::min(static_cast<std::size_t>(found - sums_.begin()), sums_.size() - 1);
  }

  /// Calls use(index, share): of all that is told, what this one tells.
  template <class Use>
  void forEach(const Use& use) const {
    for (std::size_t i = 0; i < weights_.size(); ++i) use(i, weights_[i] / sums_.back());
  }

  /// Of all that is told, the share that those tell whose index agrees.
  template <class Agrees>
  double share(const Agrees& agrees) const {
    double sum = 0.0;
    forEach([&](std::size_t i, double share) { sum += agrees(i) ? share : 0.0; });
    return sum;
  }

 private:
  /// Twice what the middle one tells, which a few that tell any number do not change; where most tell nothing, the
  /// mean.
  static double usualOf(List<double> tells) {
    constexpr double kMore = 2.0;
    double mean = 0.0;
    for (const double each : tells) mean += each / static_cast<double>(tells.size());
    const double middle = median(tells);
    return middle > 0.0 ? kMore * middle : mean;
  }

  Random random_{1};
  List<double> weights_, sums_;
};

}  // namespace primitect
