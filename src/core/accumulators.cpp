// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Peaks of the accumulators: the strongest bin, then the weighted average over it and its neighbours (sec. II-D).
#include "core/accumulators.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

/// Index of the strongest bin, the first one of several; nothing when all are empty.
std::optional<int> strongestBin(const std::vector<float>& bins) {
  const auto strongest = std::max_element(bins.begin(), bins.end());
  if (strongest == bins.end() || !(*strongest > 0.0f)) return std::nullopt;
  return static_cast<int>(strongest - bins.begin());
}

}  // namespace

Accumulators::Accumulators(int radius_bins, double angle_bin, bool average_bins)
    : radius_bins_(radius_bins),
      phi_bins_(std::max(3, static_cast<int>(std::lround(M_PI / angle_bin)))),
      average_bins_(average_bins),
      ball_(angle_bin),
      sphere_(radius_bins),
      cylinder_(static_cast<std::size_t>(radius_bins) * phi_bins_),
      cone_(static_cast<std::size_t>(radius_bins) * ball_.binCount()) {}

void Accumulators::clear() {
  plane_ = 0.0f;
  for (std::vector<float>* bins : {&sphere_, &cylinder_, &cone_}) std::fill(bins->begin(), bins->end(), 0.0f);
}

kernels::Accumulators Accumulators::view() {
  return {&plane_,
          {sphere_.data(), cylinder_.data(), cone_.data()},
          {nullptr, nullptr, nullptr},
          radius_bins_,
          phi_bins_,
          ball_.binCount(),
          static_cast<float>(1.0 / radius_bin_),
          ball_.view()};
}

std::optional<Peak> Accumulators::planePeak() const {
  if (!(plane_ > 0.0f)) return std::nullopt;
  Peak peak;
  peak.votes = plane_;
  return peak;
}

std::optional<Peak> Accumulators::spherePeak() const {
  const std::optional<int> best = strongestBin(sphere_);
  if (!best) return std::nullopt;
  Peak peak;
  double radius_sum = 0.0;
  for (int bin = std::max(0, *best - 1); bin <= std::min(radius_bins_ - 1, *best + 1); ++bin) {
    peak.votes += sphere_[bin];
    radius_sum += sphere_[bin] * binRadius(bin);
  }
  peak.radius = average_bins_ ? radius_sum / peak.votes : binRadius(*best);
  return peak;
}

std::optional<Peak> Accumulators::cylinderPeak() const {
  const std::optional<int> best = strongestBin(cylinder_);
  if (!best) return std::nullopt;
  const int best_layer = *best / phi_bins_;
  const int best_phi = *best % phi_bins_;
  Peak peak;
  double radius_sum = 0.0;
  double step_sum = 0.0;
  for (int layer = std::max(0, best_layer - 1); layer <= std::min(radius_bins_ - 1, best_layer + 1); ++layer) {
    for (int step = -1; step <= 1; ++step) {
      const double votes = cylinder_[layer * phi_bins_ + (best_phi + step + phi_bins_) % phi_bins_];
      peak.votes += votes;
      radius_sum += votes * binRadius(layer);
      step_sum += votes * step;
    }
  }
  peak.radius = average_bins_ ? radius_sum / peak.votes : binRadius(best_layer);
  peak.angle = (best_phi + (average_bins_ ? step_sum / peak.votes : 0.0)) * M_PI / phi_bins_;
  return peak;
}

std::optional<Peak> Accumulators::conePeak() const {
  const std::optional<int> best = strongestBin(cone_);
  if (!best) return std::nullopt;
  const int best_layer = *best / ball_.binCount();
  const int best_direction = *best % ball_.binCount();
  const Vec3& axis = ball_.direction(best_direction);
  Peak peak;
  double radius_sum = 0.0;
  Vec3 axis_sum = Vec3::Zero();
  for (int layer = std::max(0, best_layer - 1); layer <= std::min(radius_bins_ - 1, best_layer + 1); ++layer) {
    const float* bins = cone_.data() + static_cast<std::size_t>(layer) * ball_.binCount();
    const auto addBin = [&](int bin) {
      const Vec3& direction = ball_.direction(bin);
      peak.votes += bins[bin];
      radius_sum += bins[bin] * binRadius(layer);
      axis_sum += (direction.dot(axis) < 0.0 ? -bins[bin] : bins[bin]) * direction;
    };
    for (const int bin : ball_.neighborhood(best_direction)) addBin(bin);
  }
  peak.radius = average_bins_ ? radius_sum / peak.votes : binRadius(best_layer);
  peak.axis = average_bins_ ? Vec3(axis_sum.normalized()) : axis;
  return peak;
}

}  // namespace primitect
