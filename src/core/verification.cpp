// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Propose, select; see verification.h.
#include "core/verification.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/noise_measurement.h"

namespace primitect {
namespace {

/// What is assumed before it is measured.
NoiseModel largestNoise(const FrameScale& scale, const Params& params) {
  constexpr double kLargestNoise = 0.005;  // of d_s: with more of it nothing can be told any more
  NoiseModel noise = {kLargestNoise * scale.scene_diameter, 0.0, params.inlier_angle_deg * M_PI / 180.0,
                      toleratedScale(scale.sample_noise)};
  noise.growth = scale.image_growth;
  if (scale.depth_camera) noise.depth_share = params.inlier_depth_share / kInlierDeviations;
  return noise;
}

}  // namespace

void Verification::begin(const FrameScale& scale) {
  scale_ = scale;
  setNoise(largestNoise(scale, params_));
  noise_measured_ = false;
  weight_ = 1.0;
  samples_.clear();
  pool_.clear();
  selection_ = {};
  segments_.clear();
  wholes_.clear();
  refusals_ = {};
}

std::size_t Verification::inliersOfFirstDraw(const Segment& segment) const {
  const auto end = std::lower_bound(segment.inliers.begin(), segment.inliers.end(), samples_.first_draw);
  return static_cast<std::size_t>(end - segment.inliers.begin());
}

void Verification::setNoise(const NoiseModel& of_samples) {
  noise_ = point_noise_ = of_samples;
  point_noise_.scale = toleratedScale(scale_.image_noise);
}

NoiseModel Verification::fullNoise() const {
  NoiseModel noise = noise_;
  noise.scale = fullScale(scale_.image_noise);
  return noise;
}

double Verification::radiusBin() const { return params_.radius_bin * scale_.scene_diameter * scale_.radius_stretch; }

double Verification::largestRadius() const { return std::max(radiusBin() * params_.radius_bins, scale_.view_radius); }

/// A depth camera's samples do tell: cones of .35 m that taper by 6 or 7 deg would come out as two cylinders.
Limits Verification::sampleLimits() const {
  constexpr double kOfScene = 0.003;  // of d_s
  constexpr double kMost = 0.005;     // m
  const double sharpest = noise_.ofDepthCamera() ? 0.0 : sharpestOfSamples(params_);
  const double min_distance = scale_.from_origin ? std::min(kOfScene * scale_.scene_diameter, kMost) : 0.0;
  return {params_, largestRadius(), sharpest, min_distance};
}

ProposalRules Verification::rules() const {
  // Votes tell a shape to about a bin.
  constexpr double kMostWiden = 3.0;
  const double typical =
      noise_.ofDepthCamera() && samples_.size() > 0 ? noise_.at(samples_.point(samples_.size() / 2)) : noise_.distance;
  const double widen = std::clamp(radiusBin() / (kInlierDeviations * typical), 1.0, kMostWiden);
  ProposalRules rules = {noise_, sampleLimits(), widen, params_.pair_distance * scale_.scene_diameter};
  rules.fitted_normals = scale_.fitted_normals && noise_measured_;
  return rules;
}

void Verification::addSamples(Samples samples) {
  applyNoise(noise_, samples);
  samples_.append(samples);
  graph_.build(samples_);
  const HeldGains nothing(samples_.size(), 0.0f);
  for (Hypothesis& hypothesis : pool_) evaluate(samples_, nothing, 1.0, hypothesis);
  proposer_.begin(heldByChosen());
}

void Verification::measureNoise(Samples samples, const List<Candidate>& candidates) {
  noise_measured_ = false;
  setNoise(largestNoise(scale_, params_));
  applyNoise(noise_, samples);
  if (!params_.does(Step::noise)) return;
  const std::optional<NoiseModel> measured = primitect::measureNoise(samples, candidates, rules());
  noise_measured_ = measured.has_value();
  if (measured) setNoise(*measured);
}

/// What is selected is fitted again, to all its samples. Measured on 60 tables and 8 clouds of the paper: with 256
/// samples for each fit before that as much is found.
ProposalRules Verification::quickRules() const {
  constexpr std::size_t kEnoughToFit = 256;
  ProposalRules quick = rules();
  quick.most_fitted = kEnoughToFit;
  return quick;
}

void Verification::propose(const List<Candidate>& candidates) {
  proposer_.propose(samples_, graph_, candidates, quickRules(), pool_, refusals_);
}

HeldGains Verification::heldByChosen() const {
  HeldGains held(samples_.size(), 0.0f);
  for (const std::uint32_t h : selection_.chosen) hold(pool_[h], held);
  return held;
}

List<std::uint32_t> Verification::unexplained() { return graph_.largeParts(notHeld(heldByChosen()), needed() / 2); }

/// What is nearly the same as something chosen, and worse, has had its chance.
void Verification::dropLikenesses() {
  const auto redundant = [this](std::uint32_t h) {
    const auto& chosen = selection_.chosen;
    if (std::find(chosen.begin(), chosen.end(), h) != chosen.end()) return false;
    return std::any_of(chosen.begin(), chosen.end(), [&](std::uint32_t c) { return alike(pool_[h], pool_[c]); });
  };
  List<std::uint32_t> place(pool_.size(), kNobody);
  std::uint32_t kept = 0;
  for (std::uint32_t h = 0; h < pool_.size(); ++h) {
    if (!redundant(h)) place[h] = kept++;
  }
  if (kept == pool_.size()) return;
  for (std::uint32_t h = 0; h < pool_.size(); ++h) {
    if (place[h] != kNobody && place[h] != h) std::swap(pool_[place[h]], pool_[h]);
  }
  pool_.resize(kept);
  for (std::uint32_t& h : selection_.chosen) h = place[h];
  for (std::uint32_t& h : selection_.owner) h = h == kNobody ? kNobody : place[h];
}

void Verification::segmentSelected() {
  dropLikenesses();
  List<std::size_t> segment_of(pool_.size(), 0);
  segments_.clear();
  for (const std::uint32_t h : selection_.chosen) {
    segment_of[h] = segments_.size();
    Segment segment;
    segment.hypothesis = h;
    segment.candidate.shape = pool_[h].shape;
    segment.candidate.concave = pool_[h].concave;
    segment.candidate.votes = pool_[h].votes;
    segments_.push_back(std::move(segment));
  }
  for (std::uint32_t i = 0; i < selection_.owner.size(); ++i) {
    if (selection_.owner[i] != kNobody) segments_[segment_of[selection_.owner[i]]].inliers.push_back(i);
  }
}

void Verification::select() {
  selection_ = selectHypotheses(samples_, pool_, needed());
  segmentSelected();
}

/// After some of what was chosen has lost its support, and others have joined the pool.
void Verification::selectAgain() {
  selection_ = primitect::selectAgain(samples_, pool_, needed(), selection_.chosen);
  segmentSelected();
}

}  // namespace primitect
