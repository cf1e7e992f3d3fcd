// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes that are one, which a depth camera bends, joined; see verification.h.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "core/verification.h"

namespace primitect {
namespace {

/// How far samples, at least one, are off a plane: the mean, in deviations of their noise.
double meanDistance(const Samples& samples, const List<std::uint32_t>& set, const Shape& plane) {
  double sum = 0.0;
  for (const std::uint32_t i : set) sum += std::abs(distance(plane, samples.point(i))) / samples.sigma[i];
  return sum / static_cast<double>(set.size());
}

}  // namespace

/// Of the samples of a segment, those with one of another segment's among their neighbours, as selected last.
std::size_t Verification::countBeside(const Segment& segment, const Segment& other) const {
  const auto isBeside = [&](std::uint32_t i) {
    const SampleGraph::Neighbors& near = graph_.of(i);
    return std::any_of(near.begin(), near.end(),
                       [&](std::uint32_t j) { return selection_.owner[j] == other.hypothesis; });
  };
  return static_cast<std::size_t>(std::count_if(segment.inliers.begin(), segment.inliers.end(), isBeside));
}

/// Whether one of two planes fits the other's samples nearly; of two that lean apart, one is far off at the other's
/// ends.
bool Verification::areNearlyOnePlane(const Segment& a, const Segment& b) const {
  constexpr double kLeastCosine = 0.9986;  // 3 deg
  constexpr double kFar = 4.0;             // deviations
  const Shape &first = pool_[a.hypothesis].shape, &second = pool_[b.hypothesis].shape;
  const double cosine = std::get<Plane>(first).normal.dot(std::get<Plane>(second).normal);
  if (!(std::abs(cosine) >= kLeastCosine)) return false;
  return std::min(meanDistance(samples_, b.inliers, first), meanDistance(samples_, a.inliers, second)) <= kFar;
}

/// Whether samples of both are everywhere side by side. Of a board on a table only its rim has others beside it: up to
/// four times the root of its samples, somewhat more where it is long. Of the halves of bent tables and floors it is a
/// third of the samples and more.
bool Verification::areInterwoven(const Segment& few, const Segment& many) const {
  constexpr double kRim = 5.0, kLeast = 0.25;
  const auto samples = static_cast<double>(few.inliers.size());
  return static_cast<double>(countBeside(few, many)) > std::max(kRim * std::sqrt(samples), kLeast * samples);
}

/// One plane for the samples of both; nothing where a curved shape fits them better, those of one are worth much less
/// in it, or it is not likely. In halves of bent tables and floors samples lose .4 of a gain at most, in what is
/// another surface .57 and more.
std::optional<Hypothesis> Verification::onePlaneFor(const Segment& few, const Segment& many, const HeldGains& held) {
  constexpr double kLess = 0.45;
  Segment both;
  both.hypothesis = many.hypothesis;  // where the fit begins
  std::merge(few.inliers.begin(), few.inliers.end(), many.inliers.begin(), many.inliers.end(),
             std::back_inserter(both.inliers));
  std::optional<Hypothesis> one = alone(both.inliers, {}, both, held);
  if (!one || kindOf(one->shape) != Kind::plane) return std::nullopt;
  const auto holds = [&](const Segment& segment) {
    const double loss = worthAt(segment.inliers, pool_[segment.hypothesis]) - worthAt(segment.inliers, *one);
    return loss < kLess * static_cast<double>(segment.inliers.size());
  };
  if (!holds(few) || !holds(many)) return std::nullopt;
  List<Part> whole;
  whole.push_back({std::move(both.inliers), *one, 0.0});
  return mayBeLikely(whole, held) ? one : std::nullopt;
}

/// Silences two hypotheses, and what is like one of them: it would come back beside what takes their place.
void Verification::silenceWithLikes(std::uint32_t a, std::uint32_t b) {
  List<std::uint32_t> likes = {a, b};
  for (std::uint32_t h = 0; h < pool_.size(); ++h) {
    if (h == a || h == b || pool_[h].support.empty()) continue;
    if (alike(pool_[h], pool_[a]) || alike(pool_[h], pool_[b])) likes.push_back(h);
  }
  for (const std::uint32_t h : likes) silence(pool_[h]);
}

/// Waves of the depth are no noise to a plane's samples, and two planes through each other explain a table better than
/// one. Joins the first two large ones of those selected that are one; returns whether there were such.
bool Verification::joinPlanes() {
  if (!noise_.ofDepthCamera() || !params_.does(Step::joined_planes)) return false;
  for (std::size_t a = 0; a < segments_.size(); ++a) {
    if (!isLargePlane(segments_[a])) continue;
    for (std::size_t b = a + 1; b < segments_.size(); ++b) {
      if (!isLargePlane(segments_[b])) continue;
      const bool fewer = segments_[a].inliers.size() < segments_[b].inliers.size();
      const Segment &few = segments_[fewer ? a : b], &many = segments_[fewer ? b : a];
      if (!areNearlyOnePlane(few, many) || !areInterwoven(few, many)) continue;
      std::optional<Hypothesis> one = onePlaneFor(few, many, heldByChosen());
      if (!one) continue;
      silenceWithLikes(few.hypothesis, many.hypothesis);
      pool_.push_back(std::move(*one));
      return true;
    }
  }
  return false;
}

}  // namespace primitect
