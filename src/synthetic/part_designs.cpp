// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Four kinds of part, each a body with features at the places where such parts have them.
#include "synthetic/part_designs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "synthetic/chance.h"
#include "synthetic/part_features.h"
#include "synthetic/poses.h"

namespace primitect::synthetic {
namespace {

Pose turnedAround(const Vec3& axis, double angle) { return Pose(Eigen::AngleAxisd(angle, axis)); }

/// The four upright edges of a block, its footprint given by half lengths.
void chamferUprightEdges(Csg& part, double half_x, double half_y, double depth) {
  for (int corner = 0; corner < 4; ++corner) {
    const double x = corner & 1 ? half_x : -half_x, y = corner & 2 ? half_y : -half_y;
    Pose frame = moved(x, y, 0.0);
    frame.linear().col(0) = Vec3::UnitZ();
    frame.linear().col(2) = Vec3(x > 0.0 ? 1.0 : -1.0, y > 0.0 ? 1.0 : -1.0, 0.0).normalized();
    frame.linear().col(1) = frame.linear().col(2).cross(frame.linear().col(0));
    chamferEdge(part, frame, depth);
  }
}

/// The four edges around the top of a block.
void chamferTopEdges(Csg& part, double half_x, double half_y, double top, double depth) {
  for (int side = 0; side < 4; ++side) {
    const double reach = side % 2 == 0 ? half_y : half_x;
    // In the turned frame the edge runs along x at y = reach; a turn by -45 deg about x brings z between the faces.
    chamferEdge(part,
                turnedAround(Vec3::UnitZ(), 0.5 * kPi * side) * moved(0.0, reach, top) *
                    turnedAround(Vec3::UnitX(), -0.25 * kPi),
                depth);
  }
}

Csg drawPlate(Random& random) {
  const double half_x = 0.5, half_y = random.uniform(0.32, 0.50), half_z = random.uniform(0.09, 0.14);
  Csg part;
  part.add(block(half_x, half_y, half_z));
  if (oneIn(2, random)) chamferUprightEdges(part, half_x, half_y, random.uniform(0.05, 0.08));
  if (oneIn(2, random)) chamferTopEdges(part, half_x, half_y, half_z, random.uniform(0.035, 0.050));
  const double material = 2.0 * half_z;
  if (oneIn(2, random)) {
    drawFeature(part, {moved(0.0, 0.0, half_z), random.uniform(0.17, 0.22), material}, random);
  } else {
    for (const double x : {-0.13, 0.13}) {
      drawFeature(part, {moved(x, 0.0, half_z), random.uniform(0.100, 0.115), material}, random);
    }
  }
  const Hole hole{random.uniform(0.050, 0.060), material + 0.05, drawMouth(random)};
  for (const double x : {-0.33, 0.33}) {
    for (const double y : {0.17 - half_y, half_y - 0.17}) cutHole(part, moved(x, y, half_z), hole);
  }
  return part;
}

Csg drawFlange(Random& random) {
  const double thickness = random.uniform(0.16, 0.24), chamfer = random.uniform(0.03, 0.05);
  Csg part;
  part.add(turned({-thickness, 0.5, -chamfer, 0.5}));
  part.add(turned({-chamfer, 0.5, 0.0, 0.5 - chamfer}));
  drawFeature(part, {Pose::Identity(), random.uniform(0.18, 0.22), thickness}, random);
  const Hole hole{random.uniform(0.050, 0.062), thickness + 0.05, drawMouth(random)};
  const int count = 3 + static_cast<int>(random.below(4));
  for (int i = 0; i < count; ++i) {
    cutHole(part, turnedAround(Vec3::UnitZ(), 2.0 * kPi * i / count) * moved(0.345, 0.0, 0.0), hole);
  }
  return part;
}

/// A foot and on it an upright with a round head and a bore across.
Csg drawBearingBlock(Random& random) {
  const double half_y = random.uniform(0.20, 0.28), half_z = random.uniform(0.08, 0.10);
  const double head = random.uniform(0.18, 0.22), height = half_z + random.uniform(0.25, 0.40);
  const double half_width = random.uniform(0.09, 0.13);
  Csg part;
  part.add(block(0.5, half_y, half_z));
  if (oneIn(2, random)) chamferUprightEdges(part, 0.5, half_y, random.uniform(0.05, 0.08));
  const Pose across = moved(0.0, 0.0, height) * turnedAround(Vec3::UnitX(), 0.5 * kPi);
  part.add(block(head, half_width, 0.5 * height), moved(0.0, 0.0, 0.5 * height));
  part.add(turned({-half_width, head, half_width, head}), across);
  const double boss = half_width + random.uniform(0.04, 0.08), bore = random.uniform(0.40, 0.48) * head;
  part.add(turned({-boss, 0.8 * head, boss, 0.8 * head}), across);
  const bool sunk = oneIn(2, random);
  cutHole(part, across * moved(0.0, 0.0, boss), {bore, 2.0 * boss + 0.05, sunk ? Mouth::countersunk : Mouth::plain});
  const Hole hole{random.uniform(0.055, 0.070), 2.0 * half_z + 0.05, drawMouth(random)};
  for (const double x : {-0.36, 0.36}) cutHole(part, moved(x, 0.0, half_z), hole);
  return part;
}

/// Ends are at the origin of the frame, z out of the material.
void finishEnd(Csg& part, const Pose& frame, double radius, Random& random) {
  const double chamfer = 0.2 * radius;
  switch (random.below(4)) {
    case 0:
      return part.add(turned({0.0, radius, chamfer, radius - chamfer}), frame);
    case 1:
      return part.add({Ball{radius}}, frame);
    case 2:
      return cutHole(part, frame, {0.5 * radius, random.uniform(0.10, 0.16), drawMouth(random), true});
    default:
      return cutDimple(part, {frame, 0.7 * radius, radius});
  }
}

Csg drawShaft(Random& random) {
  Csg part;
  const int count = 3 + static_cast<int>(random.below(2));
  const int tapered = static_cast<int>(random.below(count));
  double z = 0.0, radius = random.uniform(0.13, 0.18);
  const double first_radius = radius;
  double middle = 0.0, middle_radius = 0.0;
  for (int i = 0; i < count; ++i) {
    const double length = random.uniform(0.20, 0.34);
    const double end_radius = i == tapered ? radius * random.uniform(0.70, 0.85) : radius;
    part.add(turned({z, radius, z + length, end_radius}));
    if (radius > middle_radius && i != tapered) middle = z + 0.5 * length, middle_radius = radius;
    z += length;
    const double step = random.uniform(0.04, 0.09);
    const bool wider = i == 0 || end_radius < 0.16;
    if (i + 1 < count)
      radius = wider ? end_radius + step : end_radius - step;
    else
      radius = end_radius;
  }
  finishEnd(part, moved(0.0, 0.0, z), radius, random);
  finishEnd(part, turnedAround(Vec3::UnitX(), kPi), first_radius, random);
  // At the widest section: a hole across or a flat.
  const Pose side = moved(0.0, 0.0, middle) * turnedAround(Vec3::UnitY(), 0.5 * kPi);
  if (oneIn(2, random)) {
    cutHole(part, side * moved(0.0, 0.0, middle_radius), {0.055, 2.0 * middle_radius + 0.05});
  } else {
    part.cut(block(0.08, 0.5, 0.1), side * moved(0.0, 0.0, 0.75 * middle_radius + 0.1));
  }
  return part;
}

}  // namespace

Csg drawPart(Random& random) {
  switch (random.below(4)) {
    case 0:
      return drawPlate(random);
    case 1:
      return drawFlange(random);
    case 2:
      return drawBearingBlock(random);
    default:
      return drawShaft(random);
  }
}

}  // namespace primitect::synthetic
