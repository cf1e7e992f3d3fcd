// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Competition of the four kinds; see verification.h.
#include "core/verification.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/fitting.h"

namespace primitect {
namespace {

/// Samples that nothing explains yet and that the shape may hold.
std::vector<std::uint32_t> inliersOf(const Shape& shape, const Samples& samples, const Tolerance& tolerance,
                                     const std::vector<bool>& explained) {
  std::vector<std::uint32_t> inliers;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (explained[i] || std::isinf(inlierDistance(shape, samples, i, tolerance))) continue;
    inliers.push_back(static_cast<std::uint32_t>(i));
  }
  return inliers;
}

void mark(const std::vector<std::uint32_t>& inliers, std::vector<bool>& explained) {
  for (const std::uint32_t i : inliers) explained[i] = true;
}

double radiusOf(const Shape& shape) {
  if (const Sphere* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  const Cylinder* cylinder = std::get_if<Cylinder>(&shape);
  return cylinder ? cylinder->radius : 0.0;
}

/// A patch so small that all its normals are nearly one looks like a plane with noisy normals: an arc of about 50 deg
/// is the least that makes a curved shape. 1 - |mean normal| of an arc w is 1 - sin(w/2) / (w/2).
bool turnsEnough(const Shape& shape, const SampleSet& set) {
  constexpr double kLeastTurn = 0.03;
  if (kindOf(shape) == Kind::plane) return true;
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < set.size(); ++k) sum += set.normal(k);
  return 1.0 - sum.norm() / static_cast<double>(set.size()) > kLeastTurn;
}

struct Limits {
  const Params& params;
  double max_radius;

  bool hold(const Shape& shape) const { return withinLimits(shape, params) && radiusOf(shape) <= max_radius; }
};

/// Of the samples of the set; a shape with more parameters must explain more.
double score(const Shape& shape, const SampleSet& set, const Tolerance& tolerance) {
  constexpr double kPricePerParameter = 0.01;  // of the samples
  constexpr int kParameters[] = {3, 4, 5, 6};
  double sum = 0.0;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const double away = inlierDistance(shape, set.samples, set.indices[k], tolerance);
    const double share = away / tolerance.distanceAt(set.point(k));
    if (share < 1.0) sum += 1.0 - share * share;
  }
  const double count = static_cast<double>(set.size());
  return sum - kParameters[shape.index()] * (kPricePerParameter * count + std::log(count) / 9.0);
}

std::optional<Shape> refined(const std::optional<Shape>& start, const SampleSet& set, const Tolerance& tolerance) {
  if (!start) return std::nullopt;
  return refine(*start, set, [&tolerance](const Vec3& p) { return tolerance.distanceAt(p); });
}

/// All starts for the samples of a candidate: each kind from moments, and the candidate itself.
std::vector<std::optional<Shape>> startsFor(const Candidate& candidate, const SampleSet& set) {
  return {fitFromMoments(Kind::plane, set), fitFromMoments(Kind::sphere, set), fitFromMoments(Kind::cylinder, set),
          fitFromMoments(Kind::cone, set), candidate.shape};
}

bool enabled(Kind kind, const Params& params) {
  const bool switches[] = {params.detect_planes, params.detect_spheres, params.detect_cylinders, params.detect_cones};
  return switches[static_cast<std::size_t>(kind)];
}

std::optional<Shape> compete(const Candidate& candidate, const SampleSet& set, const Tolerance& loose,
                             const Tolerance& tight, const Limits& limits) {
  std::optional<Shape> best;
  double best_score = 0.0;
  for (const std::optional<Shape>& start : startsFor(candidate, set)) {
    if (start && !enabled(kindOf(*start), limits.params)) continue;
    // First with the tolerance that gathered the samples, so that a poor start is not left where it is.
    const std::optional<Shape> shape = refined(refined(start, set, loose), set, tight);
    if (!shape || !limits.hold(*shape) || !turnsEnough(*shape, set)) continue;
    const double own_score = score(*shape, set, tight);
    if (own_score > best_score) {
      best = shape;
      best_score = own_score;
    }
  }
  return best;
}

/// 1.4826 times the median of |distance|: the standard deviation of a normal distribution, whatever lies outside.
double robustDeviation(const Shape& shape, const SampleSet& set) {
  std::vector<double> distances;
  for (std::size_t k = 0; k < set.size(); ++k) distances.push_back(std::abs(distance(shape, set.point(k))));
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return 1.4826 * *middle;
}

}  // namespace

double estimateNoiseTolerance(const Samples& samples, const std::vector<Candidate>& candidates,
                              const Tolerance& loose) {
  constexpr std::size_t kStrongest = 12;
  constexpr std::size_t kFewestInliers = 20;
  constexpr double kSmallestShare = 0.02;  // of the loose tolerance: exact data has float rounding
  const std::vector<bool> none_explained(samples.size(), false);
  std::vector<double> deviations;
  for (std::size_t k = 0; k < std::min(candidates.size(), kStrongest); ++k) {
    const std::vector<std::uint32_t> own = inliersOf(candidates[k].shape, samples, loose, none_explained);
    if (own.size() < kFewestInliers) continue;
    const SampleSet set = {samples, own};
    double smallest = loose.distance;
    for (const std::optional<Shape>& start : startsFor(candidates[k], set)) {
      const std::optional<Shape> shape = refined(start, set, loose);
      if (shape) smallest = std::min(smallest, robustDeviation(*shape, set));
    }
    deviations.push_back(smallest);
  }
  if (deviations.empty()) return loose.distance;
  const auto quartile = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 4);
  std::nth_element(deviations.begin(), quartile, deviations.end());
  return std::clamp(3.0 * *quartile, kSmallestShare * loose.distance, loose.distance);
}

void verifyCandidates(const Samples& samples, const std::vector<Candidate>& candidates, const Params& params,
                      const Tolerance& loose, const Tolerance& tight, double max_radius,
                      std::vector<Segment>& segments) {
  const std::size_t needed = static_cast<std::size_t>(params.min_inliers);
  const Limits limits = {params, max_radius};
  std::vector<bool> explained(samples.size(), false);
  for (const Segment& segment : segments)
    mark(inliersOf(segment.candidate.shape, samples, tight, explained), explained);
  for (const Candidate& candidate : candidates) {
    const std::vector<std::uint32_t> own = inliersOf(candidate.shape, samples, loose, explained);
    if (own.size() < needed) continue;
    const std::optional<Shape> shape = compete(candidate, {samples, own}, loose, tight, limits);
    if (!shape) continue;
    Segment segment = {candidate, inliersOf(*shape, samples, tight, explained)};
    if (segment.inliers.size() < needed) continue;
    segment.candidate.shape = *shape;
    mark(segment.inliers, explained);
    segments.push_back(std::move(segment));
  }
}

void refineSegments(const Samples& samples, const Params& params, const Tolerance& tight, double max_radius,
                    std::vector<Segment>& segments) {
  const Limits limits = {params, max_radius};
  for (Segment& segment : segments) {
    const std::optional<Shape> shape = refined(segment.candidate.shape, {samples, segment.inliers}, tight);
    if (shape && limits.hold(*shape)) segment.candidate.shape = *shape;
  }
}

}  // namespace primitect
