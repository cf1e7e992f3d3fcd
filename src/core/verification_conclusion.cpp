// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Facets joined, what was selected fitted again, settled and assessed, what is unlikely refused; see verification.h.
#include <algorithm>
#include <utility>

#include "core/axis_extent.h"
#include "core/evidence.h"
#include "core/facets.h"
#include "core/plane_parts.h"
#include "core/standing.h"
#include "core/twins.h"
#include "core/uneven_planes.h"
#include "core/verification.h"

namespace primitect {
namespace {

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

/// A new version joins the others, unless it is like one of them and explains no more. With all versions selections
/// take up to 15 % longer in recorded frames, and find as much.
void Verification::join(const Hypothesis& version) {
  if (!isKnown(version, pool_)) pool_.push_back(version);
}

/// What is too large for the bins of radii, or for near pairs to turn, is found in facets: the whole competes with
/// them.
void Verification::joinFacets() {
  if (!scale_.depth_camera || !params_.does(Step::facets)) return;
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

/// Parts of a plane may lie in different ones.
void Verification::split(const Segment& segment, const HeldGains& held) {
  if (!params_.does(Step::plane_parts)) return;
  const Plane plane = std::get<Plane>(pool_[segment.hypothesis].shape);
  SampleParts parts = separateParts(segment.inliers, needed(), graph_);
  for (auto& part : stepParts(samples_, plane, segment.inliers, needed())) parts.push_back(std::move(part));
  for (const List<std::uint32_t>& part : parts) {
    Hypothesis trial = pool_[segment.hypothesis];
    if (bestOfKinds(samples_, held, part, rules(), trial)) join(trial);
  }
}

/// Fits the segment again to its own samples, to all samples near it, and in parts.
void Verification::refit(const Segment& segment, const HeldGains& held) {
  constexpr double kNear = 2.5;  // times the noise: what a slightly wrong shape left behind
  const bool again = params_.does(Step::fit_again);
  Hypothesis trial = pool_[segment.hypothesis];
  ProposalRules once_more = rules();
  once_more.fitted = true;
  if (again && bestOfKinds(samples_, held, segment.inliers, once_more, trial)) join(trial);
  if (kindOf(segment.candidate.shape) == Kind::plane) split(segment, held);
  if (!again) return;
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

/// How far a curved segment stands on one of the planes, whose confidence is known.
double Verification::standingOf(const Segment& segment) const {
  double most = 0.0;
  for (const Segment& plane : segments_) {
    if (kindOf(plane.candidate.shape) != Kind::plane || isUnlikely(plane)) continue;
    const Shape& of_plane = pool_[plane.hypothesis].shape;
    most = std::max(most, standsOn(std::get<Plane>(of_plane), plane.inliers, pool_[segment.hypothesis].shape,
                                   segment.inliers, samples_));
  }
  return most;
}

/// Samples of later draws count for more in its evidence.
void Verification::countDraws(Segment& segment) const {
  const auto later = static_cast<double>(segment.inliers.size() - inliersOfFirstDraw(segment));
  segment.evidence.inliers += static_cast<float>((weight_ - 1.0) * later);
}

/// Evidence, rival and confidence of a segment that is this hypothesis, with these owners of the samples. stands: what
/// standingOf() says.
void Verification::judge(const Hypothesis& hypothesis, const List<std::uint32_t>& owner, std::uint32_t self,
                         double stands, const HeldGains& held, Segment& segment) const {
  const Kind kind = kindOf(hypothesis.shape);
  segment.evidence = gatherEvidence(samples_, graph_, owner, self, hypothesis);
  countDraws(segment);
  segment.evidence.own_noise = noise_.ofDepthCamera() ? 0.0f : 1.0f;
  if (kind != Kind::plane) {
    const Rival rival = bestRival(samples_, held, segment.inliers, rules(), hypothesis);
    segment.evidence.lead = static_cast<float>(std::min(1.0, rival.lead));
    segment.rival = rival.kind;
    segment.evidence.stands = static_cast<float>(stands);
  }
  segment.confidence = confidenceOf(kind, segment.evidence);
}

void Verification::assess(Segment& segment, const HeldGains& held) {
  const Hypothesis& hypothesis = pool_[segment.hypothesis];
  const double stands = kindOf(hypothesis.shape) == Kind::plane ? 0.0 : standingOf(segment);
  judge(hypothesis, selection_.owner, segment.hypothesis, stands, held, segment);
}

/// Planes first: others may stand on them.
void Verification::assess() {
  const HeldGains held = heldByChosen();
  for (const bool planes : {true, false}) {
    for (Segment& segment : segments_) {
      if ((kindOf(segment.candidate.shape) == Kind::plane) == planes) assess(segment, held);
    }
  }
}

/// Planes and tubes apart, and how likely everything is.
void Verification::settle() {
  constexpr int kTimes = 3;  // what takes the place of one may be another of that sort
  for (int time = 0; time < kTimes && separate(); ++time) selectAgain();
  assess();
}

void Verification::refuse(const Segment& segment, Refusal why) {
  silence(pool_[segment.hypothesis]);
  ++refusals_[why];
}

bool Verification::refuseUnlikely() {
  if (!params_.does(Step::unlikely)) return false;
  bool any = false;
  for (const Segment& segment : segments_) {
    if (!isUnlikely(segment)) continue;
    refuse(segment, Refusal::unlikely);
    any = true;
  }
  return any;
}

/// The one with fewer samples.
bool Verification::refuseTwins() {
  if (!params_.does(Step::unlikely)) return false;
  bool any = false;
  for (Segment& segment : segments_) {
    const auto isTwinOfBetter = [&](const Segment& other) {
      return other.inliers.size() > segment.inliers.size() && other.confidence > 0.0 &&
             areTwins(pool_[other.hypothesis], pool_[segment.hypothesis]);
    };
    if (std::none_of(segments_.begin(), segments_.end(), isTwinOfBetter)) continue;
    segment.confidence = 0.0;
    refuse(segment, Refusal::unlikely);
    any = true;
  }
  return any;
}

/// What bulges may be a slice of a ball, which is fitted to its samples and to those near that. False: none fits.
bool Verification::offerBall(const Segment& segment) {
  constexpr double kNear = 2.5;  // times the noise: what lies beside the slice
  Params balls = params_;
  balls.detect_planes = balls.detect_cylinders = balls.detect_cones = false;
  if (!balls.detect_spheres || !params_.does(Step::other_kinds)) return false;
  const ProposalRules usual = rules();
  const ProposalRules of_balls = {usual.noise, {balls, usual.limits.max_radius}, usual.widen, usual.reach};
  HeldGains held(samples_.size(), 0.0f);
  for (const std::uint32_t h : selection_.chosen) {
    if (h != segment.hypothesis) hold(pool_[h], held);
  }
  Hypothesis ball = pool_[segment.hypothesis];
  if (!bestOfKinds(samples_, held, segment.inliers, of_balls, ball)) return false;
  join(ball);
  evaluate(samples_, held, kNear, ball);
  List<std::uint32_t> near;
  inliersOf(ball, near);
  if (bestOfKinds(samples_, held, near, of_balls, ball)) join(ball);
  return true;
}

/// A tube through the edge of a table, a cone over three things, or a ball over the tread of a tyre may be as likely on
/// the samples as what is there. What bulges, and is no ball, is judged when it is measured.
bool Verification::refuseByImage(const AskImage& ask_image) {
  if (!ask_image || !(params_.min_confidence > 0.0) || !params_.does(Step::seen_tubes)) return false;
  bool any = false;
  for (Segment& segment : segments_) {
    if (kindOf(segment.candidate.shape) == Kind::plane) continue;
    const ImageSays says = ask_image(segment);
    if (says == ImageSays::nothing || (says == ImageSays::bulges && !offerBall(segment))) continue;
    segment.confidence = 0.0;
    refuse(segment, says == ImageSays::bulges ? Refusal::unlikely : Refusal::not_seen);
    any = true;
  }
  return any;
}

/// Among the samples that no segment has.
void Verification::addUnevenPlanes() {
  if (!noise_.ofDepthCamera() || !noise_measured_ || !params_.detect_planes) return;
  if (!params_.does(Step::uneven_planes)) return;
  HeldGains held(samples_.size(), 0.0f);
  List<std::uint32_t> owner(samples_.size(), kNobody);
  for (const Segment& segment : segments_) {
    hold(pool_[segment.hypothesis], held);
    for (const std::uint32_t i : segment.inliers) owner[i] = segment.hypothesis;
  }
  const List<UnevenPlane> planes = findUnevenPlanes(samples_, graph_, held, std::move(owner), rules());
  for (const UnevenPlane& plane : planes) {
    Segment segment;
    segment.hypothesis = static_cast<std::uint32_t>(pool_.size());
    segment.candidate.shape = plane.shape;
    segment.inliers = plane.inliers;
    segment.evidence = plane.evidence;
    countDraws(segment);
    segment.confidence = confidenceOf(Kind::plane, segment.evidence);
    Hypothesis hypothesis;
    hypothesis.shape = plane.shape;
    evaluate(samples_, held, 1.0, hypothesis);
    pool_.push_back(std::move(hypothesis));
    segments_.push_back(std::move(segment));
  }
}

void Verification::conclude(const AskImage& ask_image) {
  constexpr int kRefusals = 4, kJoins = 4;
  select();
  joinFacets();
  refit();
  for (int k = 0; k < kJoins && joinPlanes(); ++k) selectAgain();
  settle();
  for (int k = 0; (refuseUnlikely() || refuseByImage(ask_image) || refuseTwins()) && k < kRefusals; ++k) {
    selectAgain();
    settle();
  }
  // What took the place of the last ones refused may be unlikely, too; it is counted.
  const auto unlikely = [this](const Segment& segment) { return isUnlikely(segment); };
  segments_.erase(std::remove_if(segments_.begin(), segments_.end(), unlikely), segments_.end());
  addUnevenPlanes();
  // Selections that go on keep what stayed in front, whatever its size.
  std::sort(segments_.begin(), segments_.end(), [](const Segment& a, const Segment& b) {
    return a.inliers.size() != b.inliers.size() ? a.inliers.size() > b.inliers.size() : a.hypothesis < b.hypothesis;
  });
}

}  // namespace primitect
