// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cans of two radii on each other, a lid on its jar: tubes taken apart where they step; see verification.h.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "core/axis_extent.h"
#include "core/axis_steps.h"
#include "core/evidence.h"
#include "core/verification.h"

namespace primitect {
namespace {

/// Both have an axis, and these are nearly parallel: what lies under a cylinder over an ellipsoid is no pile of things.
bool areParallel(const Shape& a, const Shape& b) {
  constexpr double kLeastCosine = 0.94;  // 20 deg: the axis of a part as low as a lid is known to no more than some
  const std::optional<Vec3> axis = axisOf(a), other = axisOf(b);
  return axis && other && std::abs(axis->dot(*other)) > kLeastCosine;
}

/// Whether parts that are worth so much more are more than chance. Cans 4 mm apart gain .12 a sample and more, what is
/// one shape up to .06, as a depth camera's noise comes in waves (compare's set household, seeds 300 to 359).
bool clearlyMore(double worth, double than, std::size_t samples) {
  constexpr double kClearly = 0.07;  // of a sample's gain
  return worth > than + kClearly * static_cast<double>(samples);
}

}  // namespace

/// The best shape for a part of a segment, and what it is worth there; nothing where it has no axis parallel to that of
/// the segment's.
std::optional<Verification::Part> Verification::partOf(List<std::uint32_t> samples, const Segment& segment,
                                                       const HeldGains& held) {
  List<std::uint32_t> others;
  std::set_difference(segment.inliers.begin(), segment.inliers.end(), samples.begin(), samples.end(),
                      std::back_inserter(others));
  std::optional<Hypothesis> shape = alone(samples, others, segment, held);
  if (!shape || !areParallel(shape->shape, pool_[segment.hypothesis].shape)) return std::nullopt;
  const double worth = worthAt(samples, *shape);
  return Part{std::move(samples), std::move(*shape), worth};
}

/// The parts before and after a step along the axis, and in turn of these, whatever that is worth. Empty where there is
/// no step, or one of the parts is none.
List<Verification::Part> Verification::stepsOf(const Shape& shape, const List<std::uint32_t>& samples, int depth,
                                               const Segment& segment, const HeldGains& held) {
  List<Part> parts;
  for (List<std::uint32_t>& side : axisStepParts(samples_, shape, samples, needed())) {
    std::optional<Part> part = partOf(std::move(side), segment, held);
    if (!part) return {};
    List<Part> steps =
        depth > 1 ? stepsOf(part->hypothesis.shape, part->samples, depth - 1, segment, held) : List<Part>();
    if (steps.empty()) steps.push_back(std::move(*part));
    std::move(steps.begin(), steps.end(), std::back_inserter(parts));
  }
  return parts;
}

/// Joins neighbours along the axis that are worth hardly less as one: a can that was cut in two.
void Verification::rejoin(const Segment& segment, const HeldGains& held, List<Part>& parts) {
  const Vec3 axis = axisOf(pool_[segment.hypothesis].shape).value_or(Vec3::UnitZ());
  const auto before = [&axis](const Part& a, const Part& b) {
    return axis.dot(a.hypothesis.middle) < axis.dot(b.hypothesis.middle);
  };
  std::sort(parts.begin(), parts.end(), before);
  for (std::size_t k = 1; k < parts.size();) {
    Part &first = parts[k - 1], &second = parts[k];
    List<std::uint32_t> both;
    std::merge(first.samples.begin(), first.samples.end(), second.samples.begin(), second.samples.end(),
               std::back_inserter(both));
    const std::size_t count = both.size();
    std::optional<Part> one = partOf(std::move(both), segment, held);
    if (!one || clearlyMore(first.worth + second.worth, one->worth, count)) {
      ++k;
      continue;
    }
    first = std::move(*one);
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
    k = std::max<std::size_t>(k - 1, 1);  // it may be one with what comes before, too
  }
}

/// Whether each of the parts may be likely with the others beside it: if one will be refused, its samples speak against
/// the next, and nothing would be left of a pile that one tube leads over. What they stand on is not known yet: that
/// they stand is assumed.
bool Verification::mayBeLikely(const List<Part>& parts, const HeldGains& held) const {
  const auto number = [](std::size_t k) { return static_cast<std::uint32_t>(kNobody - 1 - k); };  // nobody else's
  List<std::uint32_t> owner(selection_.owner);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (const std::uint32_t i : parts[k].samples) owner[i] = number(k);
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    constexpr double kStands = 1.0;
    Segment segment;
    segment.inliers = parts[k].samples;
    judge(parts[k].hypothesis, owner, number(k), kStands, held, segment);
    if (isUnlikely(segment)) return false;
  }
  return true;
}

bool Verification::separateSteps(const Segment& segment, const HeldGains& held) {
  constexpr int kDepth = 3;  // steps in steps: up to eight things on each other
  if (isWhole(segment, std::nullopt)) return false;
  List<Part> parts = stepsOf(pool_[segment.hypothesis].shape, segment.inliers, kDepth, segment, held);
  if (parts.size() > 1) rejoin(segment, held, parts);
  double worth = 0.0;
  for (const Part& part : parts) worth += part.worth;
  const auto more = [&] {
    return clearlyMore(worth, worthAt(segment.inliers, pool_[segment.hypothesis]), segment.inliers.size());
  };
  if (parts.size() < 2 || !more() || !mayBeLikely(parts, held)) {
    wholes_.push_back({kindOf(segment.candidate.shape), segment.inliers, std::nullopt});
    return false;
  }
  silence(pool_[segment.hypothesis]);
  for (Part& part : parts) pool_.push_back(std::move(part.hypothesis));
  return true;
}

}  // namespace primitect
