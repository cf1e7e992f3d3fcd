// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Features as sequences of adding and cutting.
#include "synthetic/part_features.h"

#include <algorithm>
#include <cmath>

#include "synthetic/chance.h"

namespace primitect::synthetic {
namespace {

// How far what is cut reaches out of the surface, and what is added into it: faces that fall together are avoided.
constexpr double kBeyond = 0.05;
constexpr double kSunk = 0.02;

Pose raised(const Site& site, double height) { return site.frame * moved(0.0, 0.0, height); }

}  // namespace

Pose moved(double x, double y, double z) { return Pose(Eigen::Translation3d(x, y, z)); }

Placed turned(const Section& s) {
  const double length = s.z1 - s.z0;
  if (s.r0 == s.r1) return {Rod{s.r0, 0.5 * length}, moved(0.0, 0.0, 0.5 * (s.z0 + s.z1))};
  const double slope = std::abs(s.r1 - s.r0) / length;
  const double begin = std::min(s.r0, s.r1) / slope, end = std::max(s.r0, s.r1) / slope;
  const Frustum frustum{std::atan(slope), begin, end};
  if (s.r1 > s.r0) return {frustum, moved(0.0, 0.0, s.z0 - begin)};
  return {frustum, moved(0.0, 0.0, s.z1 + begin) * Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitX())};
}

Placed block(double half_x, double half_y, double half_z) { return {Box{half_x, half_y, half_z}, Pose::Identity()}; }

void chamferEdge(Csg& part, const Pose& frame, double depth) {
  constexpr double kHalfWidth = 0.3, kHalfLength = 2.0;  // enough for any edge
  part.cut(block(kHalfLength, kHalfWidth, kHalfWidth), frame * moved(0.0, 0.0, kHalfWidth - depth));
}

void cutHole(Csg& part, const Pose& frame, const Hole& hole) {
  const double wide = 1.6 * hole.radius;
  part.cut(turned({-hole.depth, hole.radius, kBeyond, hole.radius}), frame);
  if (hole.mouth == Mouth::countersunk) {
    part.cut(turned({hole.radius - wide, hole.radius, kBeyond, wide + kBeyond}), frame);  // 45 deg
  } else if (hole.mouth == Mouth::counterbored) {
    part.cut(turned({-hole.radius, wide, kBeyond, wide}), frame);
  }
  if (hole.drill_point) part.cut(turned({-hole.depth - 0.6 * hole.radius, 0.0, -hole.depth, hole.radius}), frame);
}

Mouth drawMouth(Random& random) { return static_cast<Mouth>(random.below(3)); }

void addBoss(Csg& part, const Site& site, Random& random) {
  const double height = random.uniform(0.12, 0.25), radius = site.radius;
  const double chamfer = oneIn(2, random) ? random.uniform(0.10, 0.18) * radius : 0.0;
  part.add(turned({-kSunk, radius, height - chamfer, radius}), site.frame);
  if (chamfer > 0.0) part.add(turned({height - chamfer, radius, height, radius - chamfer}), site.frame);
  const double bore = random.uniform(0.50, 0.60) * radius;
  const bool through = oneIn(2, random);
  const double depth = through ? height + site.material + kBeyond : 0.8 * height;
  cutHole(part, raised(site, height), {bore, depth, Mouth::plain, !through});
}

void addTaperedBoss(Csg& part, const Site& site, Random& random) {
  const double slope = std::tan(random.uniform(0.2, 0.5)), top = random.uniform(0.40, 0.60) * site.radius;
  const double height = std::min(0.30, (site.radius - top) / slope);
  const double radius = site.radius - height * slope;
  part.add(turned({-kSunk, site.radius + kSunk * slope, height, radius}), site.frame);
  const bool has_room = site.radius > 0.15;  // for a hole that its points can show
  if (!has_room || oneIn(2, random)) {
    part.add({Ball{radius}}, raised(site, height));
  } else {
    cutHole(part, raised(site, height), {0.6 * radius, height + site.material + kBeyond});
  }
}

void addDome(Csg& part, const Site& site, Random& random) {
  const double pedestal = oneIn(2, random) ? random.uniform(0.06, 0.12) : 0.0;
  if (pedestal > 0.0) part.add(turned({-kSunk, site.radius, pedestal, site.radius}), site.frame);
  // The lower half must stay within the material.
  const double radius = std::min(0.85 * site.radius, pedestal + site.material - kSunk);
  part.add({Ball{radius}}, raised(site, pedestal));
}

void cutDimple(Csg& part, const Site& site) {
  const double radius = 1.1 * site.radius;
  const double depth = std::min(0.6 * radius, 0.6 * site.material);
  part.cut({Ball{radius}}, raised(site, radius - depth));
}

void cutWideHole(Csg& part, const Site& site, Random& random) {
  cutHole(part, site.frame, {site.radius / 1.6, site.material + kBeyond, drawMouth(random)});
}

void cutPocket(Csg& part, const Site& site, Random& random) {
  const double half_x = random.uniform(0.8, 1.0) * site.radius, half_y = random.uniform(0.6, 0.8) * site.radius;
  const double depth = random.uniform(0.4, 0.7) * site.material;
  part.cut(block(half_x, half_y, 0.5 * (depth + kBeyond)), raised(site, 0.5 * (kBeyond - depth)));
}

void cutSlot(Csg& part, const Site& site, Random& random) {
  const double radius = random.uniform(0.40, 0.50) * site.radius, half_line = site.radius - radius;
  const double depth = oneIn(2, random) ? site.material + kBeyond : 0.5 * site.material;
  part.cut(block(half_line, radius, 0.5 * (depth + kBeyond)), raised(site, 0.5 * (kBeyond - depth)));
  for (const double x : {-half_line, half_line}) {
    part.cut(turned({-depth, radius, kBeyond, radius}), site.frame * moved(x, 0.0, 0.0));
  }
}

void drawFeature(Csg& part, const Site& site, Random& random) {
  switch (random.below(7)) {
    case 0:
      return addBoss(part, site, random);
    case 1:
      return addTaperedBoss(part, site, random);
    case 2:
      return addDome(part, site, random);
    case 3:
      return cutDimple(part, site);
    case 4:
      return cutWideHole(part, site, random);
    case 5:
      return cutPocket(part, site, random);
    default:
      return cutSlot(part, site, random);
  }
}

}  // namespace primitect::synthetic
