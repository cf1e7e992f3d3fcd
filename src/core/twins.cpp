// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// By their middles and radii; see twins.h.
#include "core/twins.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace primitect {

bool areTwins(const Hypothesis& a, const Hypothesis& b) {
  constexpr double kApart = 0.25, kDifference = 0.2;  // of the larger radius
  const auto *one = std::get_if<Sphere>(&a.shape), *other = std::get_if<Sphere>(&b.shape);
  if (!one || !other || a.concave != b.concave) return false;
  const double radius = std::max(one->radius, other->radius);
  return (one->center - other->center).norm() <= kApart * radius &&
         std::abs(one->radius - other->radius) <= kDifference * radius;
}

}  // namespace primitect
