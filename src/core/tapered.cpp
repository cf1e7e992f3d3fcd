// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Trying tapers one by one; see tapered.h.
#include "core/tapered.h"

#include "core/fitting.h"
#include "core/seen_side.h"

namespace primitect {
namespace {

/// Half angles (rad) near enough to each other, and to all that occur, that Gauss-Newton gets from one to the truth.
constexpr double kTapers[] = {0.1, 0.25, 0.45, 0.8};

}  // namespace

Cone tapered(const Cylinder& cylinder, const FitPoints& points) {
  const SeenSide seen = seenSide(cylinder, points.middle());
  Cone best;
  double most = -1.0;
  for (const double taper : kTapers) {
    for (const double way : {-1.0, 1.0}) {
      const Cone cone = coneAlong(way * cylinder.axis, seen, taper);
      const double agreed = agreement(cone, points, kEnoughToCompare);
      if (!(agreed > most)) continue;
      most = agreed;
      best = cone;
    }
  }
  return best;
}

}  // namespace primitect
