// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tops of things of nearly one height taken apart; see verification.h.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/plane_parts.h"
#include "core/verification.h"

namespace primitect {

bool Verification::isLargePlane(const Segment& segment) const {
  if (kindOf(segment.candidate.shape) != Kind::plane) return false;
  return primitect::isLargePlane(inliersOfFirstDraw(segment), samples_.first_draw);
}

bool Verification::maySupport(const Segment& segment) const {
  if (kindOf(segment.candidate.shape) != Kind::plane) return false;
  return primitect::maySupport(inliersOfFirstDraw(segment), samples_.first_draw);
}

std::optional<Vec3> Verification::levelOf(const Segment& plane) const {
  std::optional<Vec3> level;
  const Vec3 normal = std::get<Plane>(plane.candidate.shape).normal;
  for (const Segment& segment : segments_) {
    if (!maySupport(segment)) continue;
    const Vec3& other = std::get<Plane>(segment.candidate.shape).normal;
    if (!level || std::abs(normal.dot(other)) > std::abs(normal.dot(*level))) level = other;
  }
  return level;
}

bool Verification::separateTops(const Segment& segment, const HeldGains& held) {
  // In parts, what things stand on is one plane all the same.
  if (maySupport(segment)) return false;
  const std::optional<Vec3> level = levelOf(segment);
  if (isWhole(segment, level)) return false;
  const SampleParts parts = separateParts(segment.inliers, needed(), graph_);
  const SampleParts groups = coplanarGroups(samples_, parts, level);
  if (groups.size() < 2) {
    wholes_.push_back({Kind::plane, segment.inliers, level});
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
    if (std::optional<Hypothesis> top = alone(group, others, segment, held)) {
      apart.push_back(std::move(*top));
    } else if (&group == &largest) {
      return false;  // of a smaller one nothing is left, but it tilts the others no longer
    }
  }
  silence(pool_[segment.hypothesis]);
  std::move(apart.begin(), apart.end(), std::back_inserter(pool_));
  return true;
}

}  // namespace primitect
