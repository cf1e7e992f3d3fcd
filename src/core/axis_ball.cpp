// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Building the hemisphere accumulator ball; see axis_ball.h.
#include "core/axis_ball.h"

#include <algorithm>
#include <cmath>

namespace primitect {

AxisBall::AxisBall(double bin_width)
    : rings_(std::max(2, static_cast<int>(std::lround(0.5 * M_PI / bin_width)))), step_(0.5 * M_PI / rings_) {
  directions_.push_back(Vec3::UnitZ());
  ring_start_.push_back(0);
  ring_size_.push_back(1);
  for (int ring = 1; ring <= rings_; ++ring) addRing(ring);
  findNeighborhoods();
}

void AxisBall::addRing(int ring) {
  const double polar_angle = ring * step_;
  const bool equator = ring == rings_;
  // Even on the equator, so that opposite bins coincide.
  const int size = equator ? 2 * static_cast<int>(std::lround(M_PI / step_))
                           : static_cast<int>(std::lround(2.0 * M_PI * std::sin(polar_angle) / step_));
  ring_start_.push_back(binCount());
  ring_size_.push_back(size);
  for (int j = 0; j < (equator ? size / 2 : size); ++j) {
    const double azimuth = 2.0 * M_PI * j / size;
    directions_.emplace_back(std::sin(polar_angle) * std::cos(azimuth), std::sin(polar_angle) * std::sin(azimuth),
                             std::cos(polar_angle));
  }
}

void AxisBall::findNeighborhoods() {
  // The centres of bins that share a corner are at most sqrt(2) steps apart; a little more for unequal rings.
  const double cos_reach = std::cos(1.6 * step_);
  neighborhoods_.resize(directions_.size());
  for (int bin = 0; bin < binCount(); ++bin) {
    neighborhoods_[bin].push_back(bin);
    for (int other = 0; other < binCount(); ++other) {
      if (other != bin && std::abs(directions_[bin].dot(directions_[other])) > cos_reach) {
        neighborhoods_[bin].push_back(other);
      }
    }
  }
}

}  // namespace primitect
