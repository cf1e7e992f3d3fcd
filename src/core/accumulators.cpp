// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Peaks of the accumulators: the strongest bin, then the weighted average over it and its neighbours (sec. II-D).
#include "core/accumulators.h"

#include <algorithm>
#include <cmath>

#include "core/degree.h"

namespace primitect {
namespace {

/// Index of the strongest bin; nothing when there cannot be more than `beaten` votes in any neighbourhood.
std::optional<int> strongestBin(const kernels::Bins& bins, double beaten) {
  // The total is a sum of floats, a neighbourhood's votes are a sum of doubles.
  constexpr double kRounding = 1.001;
  if (!(bins.most > 0.0f) || kRounding * bins.total < beaten) return std::nullopt;
  return bins.strongest;
}

}  // namespace

bool votes(Side side, const Params& params) {
  return params.convexity == "both" || params.convexity == (side == Side::convex ? "convex" : "concave");
}

Accumulators::Accumulators(const Params& params)
    : average_bins_(params.average_bins), ball_(params.angle_bin_deg * kDegree) {
  // Rows of whole cache lines, and a bin to spare: a vote for the last one is shared with nothing.
  constexpr int kCacheLine = 16;
  bins_.radius_bins = params.radius_bins;
  bins_.radius_stride = (params.radius_bins / kCacheLine + 1) * kCacheLine;
  bins_.phi_bins = std::max(3, static_cast<int>(std::lround(M_PI / (params.angle_bin_deg * kDegree))));
  bins_.ball = ball_.view();
  const std::size_t row = static_cast<std::size_t>(bins_.radius_stride);
  for (const Side side : kSides) {
    if (!votes(side, params)) continue;
    CurvedMemory& memory = side == Side::convex ? convex_ : concave_;
    memory.sphere.resize(row);
    memory.cylinder.resize(row * bins_.phi_bins);
    memory.cone.resize(row * ball_.binCount());
  }
}

kernels::CurvedBins Accumulators::binsIn(CurvedMemory& memory, std::size_t samples) {
  if (memory.cone.empty()) return {};
  if (memory.cone_cells.size() < 4 * samples) memory.cone_cells.resize(4 * samples);
  return {{memory.sphere.data(), nullptr, 0, 0.0f, 0.0f, 0},
          {memory.cylinder.data(), nullptr, 0, 0.0f, 0.0f, 0},
          {memory.cone.data(), memory.cone_cells.data(), 0, 0.0f, 0.0f, 0}};
}

void Accumulators::prepare(double radius_bin, std::size_t samples) {
  clear();
  radius_bin_ = radius_bin;
  bins_.bins_per_meter = static_cast<float>(1.0 / radius_bin);
  bins_.convex = binsIn(convex_, samples);
  bins_.concave = binsIn(concave_, samples);
}

void Accumulators::clear(kernels::CurvedBins& bins, CurvedMemory& memory) {
  if (bins.sphere.most > 0.0f) std::fill(memory.sphere.begin(), memory.sphere.end(), 0.0f);
  if (bins.cylinder.most > 0.0f) std::fill(memory.cylinder.begin(), memory.cylinder.end(), 0.0f);
  for (std::size_t k = 0; k < bins.cone.cell_count; ++k) {
    float* cell = bins.cone.votes + bins.cone.cells[k];
    cell[0] = cell[1] = 0.0f;
  }
  bins.cone.cell_count = 0;
  for (kernels::Bins* kind : {&bins.sphere, &bins.cylinder, &bins.cone}) kind->total = kind->most = 0.0f;
}

void Accumulators::clear() {
  bins_.plane = 0.0f;
  clear(bins_.convex, convex_);
  clear(bins_.concave, concave_);
}

std::optional<Peak> Accumulators::planePeak() const {
  if (!(bins_.plane > 0.0f)) return std::nullopt;
  Peak peak;
  peak.votes = bins_.plane;
  return peak;
}

std::optional<Peak> Accumulators::spherePeak(Side side, double beaten) const {
  const std::optional<int> best = strongestBin(of(side).sphere, beaten);
  if (!best) return std::nullopt;
  const float* bins = of(side).sphere.votes;
  Peak peak;
  double radius_sum = 0.0;
  for (int bin = std::max(0, *best - 1); bin <= std::min(bins_.radius_bins - 1, *best + 1); ++bin) {
    peak.votes += bins[bin];
    radius_sum += bins[bin] * binRadius(bin);
  }
  peak.radius = average_bins_ ? radius_sum / peak.votes : binRadius(*best);
  return peak;
}

std::optional<Peak> Accumulators::cylinderPeak(Side side, double beaten) const {
  const std::optional<int> best = strongestBin(of(side).cylinder, beaten);
  if (!best) return std::nullopt;
  const int best_phi = *best / bins_.radius_stride;
  const int best_layer = *best % bins_.radius_stride;
  Peak peak;
  double radius_sum = 0.0;
  double step_sum = 0.0;
  for (int step = -1; step <= 1; ++step) {
    const int phi = (best_phi + step + bins_.phi_bins) % bins_.phi_bins;
    const float* bins = of(side).cylinder.votes + static_cast<std::ptrdiff_t>(phi) * bins_.radius_stride;
    for (int layer = std::max(0, best_layer - 1); layer <= std::min(bins_.radius_bins - 1, best_layer + 1); ++layer) {
      const double votes = bins[layer];
      peak.votes += votes;
      radius_sum += votes * binRadius(layer);
      step_sum += votes * step;
    }
  }
  peak.radius = average_bins_ ? radius_sum / peak.votes : binRadius(best_layer);
  peak.angle = (best_phi + (average_bins_ ? step_sum / peak.votes : 0.0)) * M_PI / bins_.phi_bins;
  return peak;
}

std::optional<Peak> Accumulators::conePeak(Side side, double beaten) const {
  const std::optional<int> best = strongestBin(of(side).cone, beaten);
  if (!best) return std::nullopt;
  const int best_direction = *best / bins_.radius_stride;
  const int best_layer = *best % bins_.radius_stride;
  const Vec3& axis = ball_.direction(best_direction);
  Peak peak;
  double radius_sum = 0.0;
  Vec3 axis_sum = Vec3::Zero();
  for (const int neighbor : ball_.neighborhood(best_direction)) {
    const float* bins = of(side).cone.votes + static_cast<std::ptrdiff_t>(neighbor) * bins_.radius_stride;
    double votes = 0.0;
    for (int layer = std::max(0, best_layer - 1); layer <= std::min(bins_.radius_bins - 1, best_layer + 1); ++layer) {
      votes += bins[layer];
      radius_sum += bins[layer] * binRadius(layer);
    }
    const Vec3& direction = ball_.direction(neighbor);
    peak.votes += votes;
    axis_sum += (direction.dot(axis) < 0.0 ? -votes : votes) * direction;
  }
  peak.radius = average_bins_ ? radius_sum / peak.votes : binRadius(best_layer);
  peak.axis = average_bins_ ? Vec3(axis_sum.normalized()) : axis;
  return peak;
}

}  // namespace primitect
