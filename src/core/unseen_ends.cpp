// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Walks along the axis; see unseen_ends.h.
#include "core/unseen_ends.h"

#include <algorithm>
#include <cmath>

namespace primitect {

UnseenEnds::UnseenEnds(Kind kind, const Extent& extent) : origin_(extent.origin) {
  const int longer = extent.size.x() >= extent.size.y() ? 0 : 1;
  const int column = kind == Kind::plane ? longer : 2;
  axis_ = extent.rotation.col(column);
  length_ = extent.size[column];
}

void UnseenEnds::add(const Vec3& from, const Vec3& step, std::uint8_t cut_off_by) {
  constexpr double kAlong = 0.7;                // of the step: within 45 deg of the axis
  constexpr double kNear = 0.15, kSteps = 3.0;  // of the length; pixels
  const double forward = axis_.dot(step);
  if (!(std::abs(forward) > kAlong * step.norm())) return;
  const double place = axis_.dot(from - origin_);
  // To the end that lies ahead.
  const double to_end = 0.5 * length_ - (forward > 0.0 ? place : -place);
  if (!(to_end <= std::max(kNear * length_, kSteps * std::abs(forward)))) return;
  Walks& walks = forward > 0.0 ? plus_ : minus_;
  ++walks.count;
  if (cut_off_by != 0) ++walks.cut_off;
  walks.by |= cut_off_by;
}

std::uint8_t UnseenEnds::bits() const {
  return static_cast<std::uint8_t>((minus_.unseen() ? kEndAtMinusZ : 0) | (plus_.unseen() ? kEndAtPlusZ : 0));
}

std::uint8_t UnseenEnds::cutOffBy() const {
  return static_cast<std::uint8_t>((minus_.unseen() ? minus_.by : 0) | (plus_.unseen() ? plus_.by : 0));
}

}  // namespace primitect
