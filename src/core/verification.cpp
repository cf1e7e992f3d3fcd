// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Propose, select, refit, conclude; see verification.h.
#include "core/verification.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/evidence.h"
#include "core/facets.h"
#include "core/noise_measurement.h"
#include "core/plane_parts.h"

namespace primitect {
namespace {

/// What is assumed before it is measured.
NoiseModel largestNoise(const FrameScale& scale, const Params& params) {
  constexpr double kLargestNoise = 0.005;  // of d_s: with more of it nothing can be told any more
  NoiseModel noise = {kLargestNoise * scale.scene_diameter, 0.0, params.inlier_angle_deg * M_PI / 180.0};
  if (scale.depth_camera) noise.depth_share = params.inlier_depth_share / kInlierDeviations;
  return noise;
}

std::size_t needed(const Params& params) { return static_cast<std::size_t>(params.min_inliers); }

/// The same but for one in twenty samples; both in rising order. With one in ten, as much is found.
bool nearlySame(const List<std::uint32_t>& a, const List<std::uint32_t>& b) {
  constexpr double kLeast = 0.95;
  const double needed = kLeast * static_cast<double>(std::max(a.size(), b.size()));
  if (static_cast<double>(std::min(a.size(), b.size())) < needed) return false;
  std::size_t both = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    both += *i == *j ? 1 : 0;
    const bool next_i = *i <= *j, next_j = *j <= *i;
    i += next_i, j += next_j;
  }
  return static_cast<double>(both) >= needed;
}

}  // namespace

void Verification::begin(const FrameScale& scale) {
  scale_ = scale;
  noise_ = largestNoise(scale, params_);
  noise_measured_ = false;
  samples_.clear();
  pool_.clear();
  selection_ = {};
  segments_.clear();
  whole_planes_.clear();
  refusals_ = {};
}

double Verification::radiusBin() const { return params_.radius_bin * scale_.scene_diameter * scale_.radius_stretch; }

Limits Verification::limits() const {
  return {params_, std::max(radiusBin() * params_.radius_bins, scale_.view_radius)};
}

ProposalRules Verification::rules() const {
  // Votes tell a shape to about a bin.
  constexpr double kMostWiden = 3.0;
  const double typical =
      noise_.ofDepthCamera() && samples_.size() > 0 ? noise_.at(samples_.point(samples_.size() / 2)) : noise_.distance;
  const double widen = std::clamp(radiusBin() / (kInlierDeviations * typical), 1.0, kMostWiden);
  return {noise_, limits(), widen, params_.pair_distance * scale_.scene_diameter};
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
  noise_ = largestNoise(scale_, params_);
  applyNoise(noise_, samples);
  const std::optional<NoiseModel> measured = primitect::measureNoise(samples, candidates, rules());
  noise_measured_ = measured.has_value();
  if (measured) noise_ = *measured;
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

List<std::uint32_t> Verification::unexplained() {
  const HeldGains held = heldByChosen();
  List<std::uint32_t> rest;
  for (std::uint32_t i = 0; i < held.size(); ++i) {
    if (!(held[i] > 0.0f)) rest.push_back(i);
  }
  return graph_.largeParts(rest, needed(params_) / 2);
}

void Verification::conclude() {
  constexpr int kRefusals = 4;
  select();
  joinFacets();
  refit();
  settle();
  for (int k = 0; refuseUnlikely() && k < kRefusals; ++k) {
    selectAgain();
    settle();
  }
  // What took the place of the last ones refused may be unlikely, too.
  const auto unlikely = [this](const Segment& segment) { return segment.confidence < params_.min_confidence; };
  segments_.erase(std::remove_if(segments_.begin(), segments_.end(), unlikely), segments_.end());
  // Selections that go on keep what stayed in front, whatever its size.
  std::sort(segments_.begin(), segments_.end(), [](const Segment& a, const Segment& b) {
    return a.inliers.size() != b.inliers.size() ? a.inliers.size() > b.inliers.size() : a.hypothesis < b.hypothesis;
  });
}

/// Planes apart, and how likely everything is.
void Verification::settle() {
  constexpr int kTimes = 3;  // what takes the place of one plane may be another of that sort
  for (int time = 0; time < kTimes && separate(); ++time) selectAgain();
  assess();
}

/// What is nearly the same as something chosen, and worse, has had its chance.
void Verification::dropLikenesses() {
  const auto redundant = [this](std::uint32_t h) {
    const auto& chosen = selection_.chosen;
    if (std::find(chosen.begin(), chosen.end(), h) != chosen.end()) return false;
    return std::any_of(chosen.begin(), chosen.end(),
                       [&](std::uint32_t c) { return mayOverlap(pool_[h], pool_[c]) && alike(pool_[h], pool_[c]); });
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

void Verification::select() {
  selection_ = selectHypotheses(samples_, pool_, needed(params_));
  segmentSelected();
}

/// After some of what was chosen has lost its support, and others have joined the pool.
void Verification::selectAgain() {
  selection_ = primitect::selectAgain(samples_, pool_, needed(params_), selection_.chosen);
  segmentSelected();
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

HeldGains Verification::heldByChosen() const {
  HeldGains held(samples_.size(), 0.0f);
  for (const std::uint32_t h : selection_.chosen) hold(pool_[h], held);
  return held;
}

/// A new version joins the others, unless it is like one of them and explains no more. With all versions selections
/// take up to 15 % longer in recorded frames, and find as much.
void Verification::join(const Hypothesis& version) {
  if (!isKnown(version, pool_)) pool_.push_back(version);
}

/// Parts of a plane may lie in different ones.
void Verification::split(const Segment& segment, const HeldGains& held) {
  const Plane plane = std::get<Plane>(pool_[segment.hypothesis].shape);
  SampleParts parts = separateParts(segment.inliers, needed(params_), graph_);
  for (auto& part : stepParts(samples_, plane, segment.inliers, needed(params_))) parts.push_back(std::move(part));
  for (const List<std::uint32_t>& part : parts) {
    Hypothesis trial = pool_[segment.hypothesis];
    if (bestOfKinds(samples_, held, part, rules(), trial)) join(trial);
  }
}

/// What is too large for the bins of radii, or for near pairs to turn, is found in facets: the whole competes with
/// them.
void Verification::joinFacets() {
  if (!scale_.depth_camera) return;
  List<std::uint32_t> number(pool_.size(), kOther);
  std::uint32_t planes = 0;
  for (const Segment& segment : segments_) {
    if (kindOf(segment.candidate.shape) == Kind::plane) number[segment.hypothesis] = planes++;
  }
  List<std::uint32_t> plane_of(selection_.owner);
  for (std::uint32_t& owner : plane_of) owner = owner == kNobody ? kNobody : number[owner];
  const SampleParts groups = facetGroups(samples_, graph_, plane_of, planes);
  if (groups.empty()) return;
  const HeldGains held = heldByChosen();
  const std::size_t before = pool_.size();
  for (const List<std::uint32_t>& group : groups) {
    Hypothesis whole;
    whole.shape = pool_[selection_.owner[group.front()]].shape;
    const bool curved = bestOfKinds(samples_, held, group, quickRules(), whole) && kindOf(whole.shape) != Kind::plane;
    if (curved) pool_.push_back(std::move(whole));
  }
  if (pool_.size() > before) select();
}

/// Fits the segment again to its own samples, to all samples near it, and in parts.
void Verification::refit(const Segment& segment, const HeldGains& held) {
  constexpr double kNear = 2.5;  // times the noise: what a slightly wrong shape left behind
  Hypothesis trial = pool_[segment.hypothesis];
  ProposalRules once_more = rules();
  once_more.fitted = true;
  if (bestOfKinds(samples_, held, segment.inliers, once_more, trial)) join(trial);
  if (kindOf(segment.candidate.shape) == Kind::plane) split(segment, held);
  evaluate(samples_, held, kNear, trial);
  List<std::uint32_t> near;
  inliersOf(trial, near);
  if (near.size() <= segment.inliers.size() * 21 / 20) return;
  if (bestOfKinds(samples_, held, near, rules(), trial)) join(trial);
}

/// What was selected is fitted again; then it competes with what it was.
void Verification::refit() {
  constexpr int kTimes = 2;
  List<List<std::uint32_t>> refitted;  // inliers that were fitted again
  for (int time = 0; time < kTimes; ++time) {
    const HeldGains held = heldByChosen();
    const std::size_t before = pool_.size();
    for (const Segment& segment : segments_) {
      // The same samples hardly give another shape; but the few that a plane gained or lost may part it.
      const bool plane = kindOf(segment.candidate.shape) == Kind::plane;
      const auto known = [&segment, plane](const List<std::uint32_t>& set) {
        return plane ? set == segment.inliers : nearlySame(set, segment.inliers);
      };
      if (std::any_of(refitted.begin(), refitted.end(), known)) continue;
      refitted.push_back(segment.inliers);
      refit(segment, held);
    }
    if (pool_.size() == before) return;
    select();
  }
}

bool Verification::isLargePlane(const Segment& segment) const {
  if (kindOf(segment.candidate.shape) != Kind::plane) return false;
  const auto end = std::lower_bound(segment.inliers.begin(), segment.inliers.end(), samples_.first_draw);
  return primitect::isLargePlane(static_cast<std::size_t>(end - segment.inliers.begin()), samples_.first_draw);
}

std::optional<Vec3> Verification::levelOf(const Segment& plane) const {
  std::optional<Vec3> level;
  const Vec3 normal = std::get<Plane>(plane.candidate.shape).normal;
  for (const Segment& segment : segments_) {
    if (!isLargePlane(segment)) continue;
    const Vec3& other = std::get<Plane>(segment.candidate.shape).normal;
    if (!level || std::abs(normal.dot(other)) > std::abs(normal.dot(*level))) level = other;
  }
  return level;
}

/// Tops of things of nearly the same height that a plane leads over become planes of their own.
bool Verification::separate() {
  const HeldGains held = heldByChosen();
  bool any = false;
  for (const Segment& segment : segments_) {
    if (kindOf(segment.candidate.shape) == Kind::plane && separate(segment, held)) any = true;
  }
  return any;
}

bool Verification::isWhole(const List<std::uint32_t>& inliers, const std::optional<Vec3>& level) const {
  return std::any_of(whole_planes_.begin(), whole_planes_.end(),
                     [&](const WholePlane& plane) { return plane.inliers == inliers && plane.level == level; });
}

bool Verification::separate(const Segment& segment, const HeldGains& held) {
  // In parts, what things stand on is one plane all the same.
  if (isLargePlane(segment)) return false;
  const std::optional<Vec3> level = levelOf(segment);
  if (isWhole(segment.inliers, level)) return false;
  const SampleParts parts = separateParts(segment.inliers, needed(params_), graph_);
  const SampleParts groups = coplanarGroups(samples_, parts, level);
  if (groups.size() < 2) {
    whole_planes_.push_back({segment.inliers, level});
    return false;
  }
  const auto smaller = [](const auto& a, const auto& b) { return a.size() < b.size(); };
  const List<std::uint32_t>& largest = *std::max_element(groups.begin(), groups.end(), smaller);
  List<Hypothesis> apart;
  for (const List<std::uint32_t>& group : groups) {
    List<std::uint32_t> others;
    for (const List<std::uint32_t>& other : groups) {
      if (&other != &group) others.insert(others.end(), other.begin(), other.end());
    }
    std::sort(others.begin(), others.end());
    // What belongs to the other groups neither speaks against it nor is its own.
    HeldGains held_by_others = held;
    for (const std::uint32_t i : segment.inliers) held_by_others[i] = 0.0f;
    for (const std::uint32_t i : others) held_by_others[i] = 1.0f;
    Hypothesis alone = pool_[segment.hypothesis];
    if (bestOfKinds(samples_, held_by_others, group, rules(), alone)) {
      withhold(others, alone);
      apart.push_back(std::move(alone));
    } else if (&group == &largest) {
      return false;  // of a smaller one nothing is left, but it tilts the others no longer
    }
  }
  silence(pool_[segment.hypothesis]);
  std::move(apart.begin(), apart.end(), std::back_inserter(pool_));
  return true;
}

void Verification::assess() {
  const HeldGains held = heldByChosen();
  for (Segment& segment : segments_) {
    const Hypothesis& hypothesis = pool_[segment.hypothesis];
    const Kind kind = kindOf(hypothesis.shape);
    segment.evidence = gatherEvidence(samples_, graph_, selection_.owner, segment.hypothesis, hypothesis);
    segment.evidence.own_noise = noise_.ofDepthCamera() ? 0.0f : 1.0f;
    if (kind != Kind::plane) {
      const Rival rival = bestRival(samples_, held, segment.inliers, rules(), hypothesis);
      segment.evidence.lead = static_cast<float>(std::min(1.0, rival.lead));
      segment.rival = rival.kind;
    }
    segment.confidence = confidenceOf(kind, segment.evidence);
  }
}

bool Verification::refuseUnlikely() {
  bool any = false;
  for (const Segment& segment : segments_) {
    if (segment.confidence >= params_.min_confidence) continue;
    silence(pool_[segment.hypothesis]);
    ++refusals_[Refusal::unlikely];
    any = true;
  }
  return any;
}

}  // namespace primitect
