// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a machinist puts on a surface. A feature's frame has its origin in that surface and z out of the material.
#pragma once

#include <Eigen/Geometry>

#include "core/random.h"
#include "synthetic/csg.h"

namespace primitect::synthetic {

using Pose = Eigen::Isometry3d;

Pose moved(double x, double y, double z);

/// Turned on a lathe: around z, from height z0 with radius r0 to z1 > z0 with r1. A rod or a frustum.
struct Section {
  double z0, r0, z1, r1;
};
Placed turned(const Section& section);

/// A box of these half lengths around the origin of its frame.
Placed block(double half_x, double half_y, double half_z);

/// Takes off an edge through the frame's origin along x; z points out between both faces. depth: from edge to chamfer.
void chamferEdge(Csg& part, const Pose& frame, double depth);

enum class Mouth { plain, countersunk, counterbored };

/// The mouth is 1.6 times as wide as the hole.
struct Hole {
  double radius, depth;
  Mouth mouth = Mouth::plain;
  bool drill_point = false;  ///< below depth, a cone
};
void cutHole(Csg& part, const Pose& frame, const Hole& hole);
Mouth drawMouth(Random& random);

/// Where a feature may be: within radius around the frame's origin, with this much material below.
struct Site {
  Pose frame;
  double radius, material;
};

/// Straight, its upper edge perhaps chamfered, with a hole through everything or into it.
void addBoss(Csg& part, const Site& site, Random& random);
/// Narrower to the top, with a dome or a hole in it.
void addTaperedBoss(Csg& part, const Site& site, Random& random);
/// Half a ball, perhaps on a pedestal.
void addDome(Csg& part, const Site& site, Random& random);
/// Part of a ball cut in.
void cutDimple(Csg& part, const Site& site);
/// A wide hole through the material.
void cutWideHole(Csg& part, const Site& site, Random& random);
/// Rectangular.
void cutPocket(Csg& part, const Site& site, Random& random);
/// With round ends, through the material or half way.
void cutSlot(Csg& part, const Site& site, Random& random);

/// Any of these.
void drawFeature(Csg& part, const Site& site, Random& random);

}  // namespace primitect::synthetic
