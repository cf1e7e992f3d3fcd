// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Collecting the votes of each reference and turning the strongest peak into a candidate.
#include "core/pair_voting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/degree.h"
#include "core/segmentation.h"

namespace primitect {
namespace {

// Where samples are dense, as in the closer look, the nearest pairs tell nearly as much as all: what
// they vote for is fitted to all samples near it.
constexpr int kMostBoxes = 8;

Vec3 toEigen(const kernels::Vector& v) { return {v.x, v.y, v.z}; }

kernels::Vector fromEigen(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

kernels::VotingRules votingRules(const Params& params, double scene_diameter) {
  const double reach = params.pair_distance * scene_diameter;
  const double epsilon = params.epsilon_deg * kDegree;
  kernels::VotingRules rules;
  rules.max_distance_sq = static_cast<float>(reach * reach);
  rules.epsilon = static_cast<float>(epsilon);
  rules.most_boxes = params.verify ? kMostBoxes : 0;
  rules.cos_epsilon = static_cast<float>(std::cos(epsilon));
  rules.sin_epsilon_sq = static_cast<float>(std::sin(epsilon) * std::sin(epsilon));
  rules.convex = votes(Side::convex, params);
  rules.concave = votes(Side::concave, params);
  rules.spread = params.spread_votes;
  rules.convex_planes = params.convex_planes;
  rules.planes = params.detect_planes;
  rules.spheres = params.detect_spheres;
  rules.cylinders = params.detect_cylinders;
  rules.cones = params.detect_cones;
  return rules;
}

kernels::Reference referenceAt(const Samples& samples, std::size_t i) {
  const Vec3 normal = samples.normal(i);
  const Vec3 tangent_y = normal.unitOrthogonal();
  return {{fromEigen(samples.point(i)), fromEigen(normal)}, fromEigen(tangent_y), fromEigen(normal.cross(tangent_y))};
}

Sphere sphereFromVotes(const Vec3& point, const Vec3& normal, double radius) {
  return {point - radius * normal, radius};
}

Cylinder cylinderFromVotes(const Vec3& point, const Vec3& normal, const Vec3& axis, double radius) {
  return {point - radius * normal, axis, radius};
}

std::optional<Cone> coneFromVotes(const Vec3& point, const Vec3& normal, const Vec3& axis, double axis_distance) {
  constexpr double kSmallestSine = 1e-6;
  const double across = axis.dot(normal);
  if (std::abs(across) < kSmallestSine || std::abs(across) > 1.0 - kSmallestSine) return std::nullopt;
  const Vec3 apex = point + axis_distance * (axis / across - normal);
  const Vec3 signed_axis = (point - apex).dot(axis) < 0.0 ? Vec3(-axis) : axis;
  const double sine = -signed_axis.dot(normal);
  if (!(sine > 0.0)) return std::nullopt;
  return Cone{apex, signed_axis, std::asin(std::min(sine, 1.0))};
}

PairVoting::PairVoting(const Params& params)
    : params_(params),
      most_references_(static_cast<std::size_t>(params.references)),
      kernels_(kernels::chosenKernels()),
      accumulators_(params) {}

void PairVoting::propose(const Peak& peak, Candidate candidate, std::optional<Candidate>& best) const {
  if (!(peak.votes > toBeat(best))) return;
  candidate.votes = peak.votes;
  best = candidate;
}

void PairVoting::proposeCurved(const kernels::Reference& reference, Side side, std::optional<Candidate>& best) const {
  const bool concave = side == Side::concave;
  const Vec3 point = toEigen(reference.sample.point);
  const Vec3 normal = toEigen(reference.sample.normal);
  const Vec3 outward = concave ? Vec3(-normal) : normal;
  if (const auto peak = accumulators_.spherePeak(side, toBeat(best))) {
    propose(*peak, {sphereFromVotes(point, outward, peak->radius), concave, point, normal}, best);
  }
  if (const auto peak = accumulators_.cylinderPeak(side, toBeat(best)); peak && peak->votes > toBeat(best)) {
    const Vec3 axis =
        std::cos(peak->angle) * toEigen(reference.tangent_y) + std::sin(peak->angle) * toEigen(reference.tangent_z);
    propose(*peak, {cylinderFromVotes(point, outward, axis, peak->radius), concave, point, normal}, best);
  }
  if (const auto peak = accumulators_.conePeak(side, toBeat(best)); peak && peak->votes > toBeat(best)) {
    const std::optional<Cone> cone = coneFromVotes(point, outward, peak->axis, peak->radius);
    if (cone && withinLimits(*cone, params_)) propose(*peak, {*cone, concave, point, normal}, best);
  }
}

std::optional<Candidate> PairVoting::strongest(const kernels::Reference& reference) const {
  const Vec3 point = toEigen(reference.sample.point);
  const Vec3 normal = toEigen(reference.sample.normal);
  std::optional<Candidate> best;
  if (const auto peak = accumulators_.planePeak()) propose(*peak, {Plane{point, normal}, false, point, normal}, best);
  for (const Side side : kSides) proposeCurved(reference, side, best);
  return best;
}

void PairVoting::begin(const Samples& samples, double scene_diameter) {
  // A shape that is verified needs one good candidate, not the votes of all: every third sample proposes enough.
  constexpr std::size_t kSamplesPerVerified = 3;
  samples_ = &samples;
  references_ = std::min(samples.size() / (params_.verify ? kSamplesPerVerified : 1), most_references_);
  rules_ = votingRules(params_, scene_diameter);
  if (all_pairs_) rules_.most_boxes = 0;
  boxes_.enclose(samples);
  accumulators_.prepare(params_.radius_bin * scene_diameter * radius_stretch_, samples.size());
}

void PairVoting::voteAt(std::uint32_t sample, List<Candidate>& candidates) {
  if (!samples_->hasNormal(sample)) return;
  const kernels::Boxes boxes = boxes_.view();
  kernels::Samples view = samples_->view();
  view.boxes = &boxes;
  const kernels::Reference reference = referenceAt(*samples_, sample);
  kernels_.vote(reference, view, rules_, accumulators_.bins());
  if (std::optional<Candidate> candidate = strongest(reference)) {
    candidate->sample = sample;
    candidates.push_back(*candidate);
  }
  accumulators_.clear();
}

void PairVoting::vote(const Samples& samples, double scene_diameter, List<Candidate>& candidates) {
  candidates.clear();
  begin(samples, scene_diameter);
  for (std::size_t k = 0; k < references(); ++k) voteAt(reference(k), candidates);
}

}  // namespace primitect
