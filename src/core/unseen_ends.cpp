// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Walks along the axis; see unseen_ends.h.
#include "core/unseen_ends.h"

#include <algorithm>
#include <cmath>

namespace primitect {

UnseenEnds::UnseenEnds(const Extent& extent) : extent_(extent) {}

void UnseenEnds::add(const Vec3& from, const Vec3& step, bool cut_off) {
  constexpr double kAlong = 0.7;                // of the step: within 45 deg of the axis
  constexpr double kNear = 0.15, kSteps = 3.0;  // of the length; pixels
  const Vec3 axis = extent_.rotation.col(2);
  const double forward = axis.dot(step);
  if (!(std::abs(forward) > kAlong * step.norm())) return;
  const double place = axis.dot(from - extent_.origin), length = extent_.size.z();
  // To the end that lies ahead.
  const double to_end = 0.5 * length - (forward > 0.0 ? place : -place);
  if (!(to_end <= std::max(kNear * length, kSteps * std::abs(forward)))) return;
  Walks& walks = forward > 0.0 ? plus_ : minus_;
  ++walks.count;
  if (cut_off) ++walks.cut_off;
}

std::uint8_t UnseenEnds::bits() const {
  const auto unseen = [](const Walks& walks) { return 2 * walks.cut_off >= walks.count; };
  return static_cast<std::uint8_t>((unseen(minus_) ? kEndAtMinusZ : 0) | (unseen(plus_) ? kEndAtPlusZ : 0));
}

}  // namespace primitect
