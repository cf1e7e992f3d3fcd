// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Image, image again, or list; see arrangement.h.
#include "core/arrangement.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/normals.h"
#include "core/random.h"
#include "primitect/detector.h"

namespace primitect {
namespace {

/// Lists come in a few columns or rows, too: into these no window fits.
bool isNarrow(const Cloud& cloud) {
  constexpr std::uint32_t kNarrowest = 5;
  return cloud.organized() && std::min(cloud.width, cloud.height) < kNarrowest;
}

/// Lists in a few rows may be in any order, and then their columns tell nothing.
bool mayBeList(const Cloud& cloud) {
  constexpr std::uint32_t kFewest = 16;
  return std::min(cloud.width, cloud.height) < kFewest;
}

}  // namespace

/// One pixel behind the sensor, where min_depth is 0, would make a list of an image.
const Cloud& Arrangement::withoutStrays(const Cloud& cloud) {
  if (!cloud.organized() || cloud.behind_count == 0 || cloud.liesBehind()) return cloud;
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  in_front_ = cloud;
  for (std::size_t i = 0; i < in_front_.size(); ++i) {
    if (in_front_.z[i] <= 0.0f) in_front_.x[i] = in_front_.y[i] = in_front_.z[i] = kMissing;
  }
  in_front_.countPoints();
  return in_front_;
}

const Cloud& Arrangement::asList(const Cloud& cloud) {
  if (!cloud.organized()) return cloud;
  list_ = cloud;
  list_.width = static_cast<std::uint32_t>(cloud.size()), list_.height = 1;
  return list_;
}

const Cloud& Arrangement::projectedOrList(const Cloud& cloud) {
  const Cloud& list = asList(cloud);
  is_projected_ = projected_.make(list) && projected_.image().valid_count >= kFewestPoints;
  // Columns of a list in a few rows tell nothing: an image that can be made of it tells more.
  seen_from_origin_ = is_projected_ || (seen_from_origin_ && projected_.seenFromOrigin());
  return is_projected_ ? projected_.image() : list;
}

const Cloud& Arrangement::of(const Cloud& given, bool brings_normals) {
  is_projected_ = false;
  seen_from_origin_ = !given.liesBehind();
  const Cloud& cloud = withoutStrays(given);
  rays_.reset();
  if (cloud.organized() && !isNarrow(cloud)) {
    const ImageRays rays = findRays(cloud);
    seen_from_origin_ = seen_from_origin_ && rays.seen_from_origin;
    if (rays.seen_from_origin && (brings_normals || !isSparse(cloud))) {
      rays_ = rays;
      return cloud;
    }
    if (!rays.seen_from_origin && !mayBeList(cloud)) return asList(cloud);
  }
  return brings_normals ? asList(cloud) : projectedOrList(cloud);
}

bool mayBeOfDepthCamera(const Cloud& cloud) {
  constexpr int kLookedAt = 256;
  constexpr double kFarthest = 10.0;  // m, on average
  if (!isDepthImage(cloud)) return false;
  Random random(1);
  double sum = 0.0, count = 0.0;
  for (int k = 0; k < kLookedAt; ++k) {
    const std::size_t i = random.below(cloud.size());
    if (cloud.valid(i)) sum += cloud.z[i], count += 1.0;
  }
  return sum <= kFarthest * count;
}

}  // namespace primitect
