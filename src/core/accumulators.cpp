// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Peaks of the accumulators: the strongest bin, then the weighted average over it and its neighbours (sec. II-D).
#include "core/accumulators.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// Index of the strongest bin, the first one of several; nothing when all are empty.
std::optional<int> strongestBin(const std::vector<float>& bins) {
  const auto strongest = std::max_element(bins.begin(), bins.end());
  if (strongest == bins.end() || !(*strongest > 0.0f)) return std::nullopt;
  return static_cast<int>(strongest - bins.begin());
}

}  // namespace

bool votes(Side side, const Params& params) {
  return params.convexity == "both" || params.convexity == (side == Side::convex ? "convex" : "concave");
}

Accumulators::Accumulators(const Params& params)
    : radius_bins_(params.radius_bins),
      phi_bins_(std::max(3, static_cast<int>(std::lround(M_PI / (params.angle_bin_deg * kDegree))))),
      average_bins_(params.average_bins),
      ball_(params.angle_bin_deg * kDegree) {
  const std::size_t layers = static_cast<std::size_t>(radius_bins_);
  const Curved empty = {std::vector<float>(layers), std::vector<float>(layers * phi_bins_),
                        std::vector<float>(layers * ball_.binCount())};
  if (votes(Side::convex, params)) convex_ = empty;
  if (votes(Side::concave, params)) concave_ = empty;
}

void Accumulators::clear() {
  plane_ = 0.0f;
  for (Curved* side : {&convex_, &concave_}) {
    for (std::vector<float>* bins : {&side->sphere, &side->cylinder, &side->cone}) {
      std::fill(bins->begin(), bins->end(), 0.0f);
    }
  }
}

kernels::Accumulators Accumulators::view() {
  return {&plane_,
          convex_.view(),
          concave_.view(),
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

std::optional<Peak> Accumulators::spherePeak(Side side) const {
  const std::vector<float>& bins = of(side).sphere;
  const std::optional<int> best = strongestBin(bins);
  if (!best) return std::nullopt;
  Peak peak;
  double radius_sum = 0.0;
  for (int bin = std::max(0, *best - 1); bin <= std::min(radius_bins_ - 1, *best + 1); ++bin) {
    peak.votes += bins[bin];
    radius_sum += bins[bin] * binRadius(bin);
  }
  peak.radius = average_bins_ ? radius_sum / peak.votes : binRadius(*best);
  return peak;
}

std::optional<Peak> Accumulators::cylinderPeak(Side side) const {
  const std::vector<float>& bins = of(side).cylinder;
  const std::optional<int> best = strongestBin(bins);
  if (!best) return std::nullopt;
  const int best_layer = *best / phi_bins_;
  const int best_phi = *best % phi_bins_;
  Peak peak;
  double radius_sum = 0.0;
  double step_sum = 0.0;
  for (int layer = std::max(0, best_layer - 1); layer <= std::min(radius_bins_ - 1, best_layer + 1); ++layer) {
    for (int step = -1; step <= 1; ++step) {
      const double votes = bins[layer * phi_bins_ + (best_phi + step + phi_bins_) % phi_bins_];
      peak.votes += votes;
      radius_sum += votes * binRadius(layer);
      step_sum += votes * step;
    }
  }
  peak.radius = average_bins_ ? radius_sum / peak.votes : binRadius(best_layer);
  peak.angle = (best_phi + (average_bins_ ? step_sum / peak.votes : 0.0)) * M_PI / phi_bins_;
  return peak;
}

std::optional<Peak> Accumulators::conePeak(Side side) const {
  const std::vector<float>& layers = of(side).cone;
  const std::optional<int> best = strongestBin(layers);
  if (!best) return std::nullopt;
  const int best_layer = *best / ball_.binCount();
  const int best_direction = *best % ball_.binCount();
  const Vec3& axis = ball_.direction(best_direction);
  Peak peak;
  double radius_sum = 0.0;
  Vec3 axis_sum = Vec3::Zero();
  for (int layer = std::max(0, best_layer - 1); layer <= std::min(radius_bins_ - 1, best_layer + 1); ++layer) {
    const float* bins = layers.data() + static_cast<std::size_t>(layer) * ball_.binCount();
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
