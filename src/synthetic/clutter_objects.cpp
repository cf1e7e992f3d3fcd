// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sizes and poses of single things, and how they come together.
#include "synthetic/clutter_objects.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "synthetic/chance.h"
#include "synthetic/poses.h"

namespace primitect::synthetic {
namespace {

Object drawClutterBall(Random& random) {
  const double radius = random.uniform(0.025, 0.080);
  return {"sphere", Ball{radius}, at(0.0, radius), 0.0, radius};
}

/// Any solid of revolution with this radius and half length around its middle.
Object upright(const char* name, const Solid& solid, double radius, double half_length) {
  return {name, solid, at(0.0, half_length), 0.0, radius};
}

Object lying(const char* name, const Solid& solid, double radius, double half_length) {
  return {name, solid, at(0.0, radius) * tilted(kPi / 2), half_length, radius};
}

Object drawClutterRod(Random& random) {
  const double radius = random.uniform(0.020, 0.055), half_length = random.uniform(0.040, 0.120);
  const Rod rod{radius, half_length};
  return oneIn(2, random) ? lying("cylinder", rod, radius, half_length) : upright("cylinder", rod, radius, half_length);
}

Object drawCup(Random& random) {
  const double radius = random.uniform(0.032, 0.060), half_length = random.uniform(0.030, 0.065);
  const double wall = random.uniform(0.002, 0.005);
  const Cup cup{radius, radius - wall, half_length, wall};
  return oneIn(4, random) ? lying("cup", cup, radius, half_length) : upright("cup", cup, radius, half_length);
}

Object drawBowl(Random& random) {
  const double radius = random.uniform(0.055, 0.105), wall = random.uniform(0.003, 0.006);
  const double rim = radius * random.uniform(-0.2, 0.2), foot = -radius + 0.4 * wall;
  return {"bowl", Bowl{radius, radius - wall, rim, foot}, at(0.0, -foot), 0.0, radius};
}

/// The apex on the table and the axis rising by the half angle, so that a line of the mantle lies on the table.
Object lyingCone(const char* name, const Solid& solid, const Frustum& outside) {
  const double cosine = std::cos(outside.half_angle);
  const double middle = 0.5 * (outside.begin + outside.end) * cosine;
  const double half_line = 0.5 * (outside.end - outside.begin) * cosine;
  const double radius = outside.end * std::tan(outside.half_angle);
  return {name, solid, at(-middle, 0.0) * tilted(kPi / 2 - outside.half_angle), half_line, radius};
}

/// The wide end on the table.
Object upsideDown(const char* name, const Solid& solid, const Frustum& outside) {
  return {name, solid, at(0.0, outside.end) * tilted(kPi), 0.0, outside.end * std::tan(outside.half_angle)};
}

Object drawClutterCone(Random& random) {
  const double half_angle = random.uniform(10.0, 35.0) * kDegree;
  const double radius = random.uniform(0.040, 0.075);
  const double end = radius / std::tan(half_angle);
  const double tallest = random.uniform(0.100, 0.180);
  const double begin = std::max(oneIn(2, random) ? end * random.uniform(0.2, 0.5) : 0.0, end - tallest);
  const Frustum frustum{half_angle, begin, end};
  return oneIn(3, random) ? lyingCone("cone", frustum, frustum) : upsideDown("cone", frustum, frustum);
}

/// A flower pot or a paper cup.
Object drawPot(Random& random) {
  const double half_angle = random.uniform(8.0, 25.0) * kDegree;
  const double radius = random.uniform(0.045, 0.080), height = random.uniform(0.06, 0.12);
  const double end = radius / std::tan(half_angle);
  const double begin = std::max(end - height, 0.35 * end);
  const double wall = random.uniform(0.002, 0.005);
  const Pot pot{half_angle, begin, end, wall, std::max(begin, wall / std::sin(half_angle)) + wall};
  const Frustum outside{half_angle, begin, end};
  if (oneIn(3, random)) return lyingCone("pot", pot, outside);
  if (oneIn(4, random)) return upsideDown("pot", pot, outside);
  return {"pot", pot, at(0.0, -begin), 0.0, radius};
}

/// Each half axis at least a quarter shorter than the one before, in any order.
Object drawEllipsoid(Random& random) {
  std::array<double, 3> half;
  half[0] = random.uniform(0.050, 0.090);
  half[1] = half[0] * random.uniform(0.60, 0.75);
  half[2] = half[1] * random.uniform(0.60, 0.75);
  std::rotate(half.begin(), half.begin() + random.below(3), half.end());
  return {"ellipsoid", Ellipsoid{half[0], half[1], half[2]}, at(0.0, half[2]), 0.0, std::max(half[0], half[1])};
}

Object drawTorus(Random& random) {
  const double tube = random.uniform(0.012, 0.025), ring = tube + random.uniform(0.020, 0.045);
  const Torus torus{ring, tube};
  const Eigen::AngleAxisd on_edge(kPi / 2, Vec3::UnitX());
  if (oneIn(3, random)) return {"torus", torus, at(0.0, ring + tube) * on_edge, ring, tube};
  return {"torus", torus, at(0.0, tube), 0.0, ring + tube};
}

/// Depth of the lowest point under the centre (m), from above by less than 0.1 mm.
double lowest(const Lump& lump) {
  double depth = 0.0;
  constexpr int kSteps = 120;
  for (int row = kSteps / 2; row <= kSteps; ++row) {
    for (int column = 0; column < 2 * kSteps; ++column) {
      const double down = kPi * row / kSteps, around = kPi * column / kSteps;
      const Vec3 d(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down));
      depth = std::max(depth, -d.z() * lump.reach(d));
    }
  }
  return depth + 0.0001;
}

Object drawLump(Random& random) {
  const Lump lump{random.uniform(0.040, 0.065), random.uniform(0.15, 0.30), random.uniform(4.0, 7.0),
                  random.uniform(0.0, 2.0 * kPi)};
  return {"lump", lump, at(0.0, lowest(lump)), 0.0, lump.radius * (1.0 + lump.bump)};
}

}  // namespace

Object drawBox(Random& random) {
  const double half_x = random.uniform(0.030, 0.090), half_y = random.uniform(0.025, half_x);
  const double half_z = random.uniform(0.020, 0.090);
  return {"box", Box{half_x, half_y, half_z}, at(0.0, half_z), half_x, half_y};
}

Object drawShapeless(Random& random) {
  constexpr std::array<Object (*)(Random&), 3> kDraw = {drawEllipsoid, drawTorus, drawLump};
  return kDraw[random.below(kDraw.size())](random);
}

Object drawPrimitive(Random& random) {
  constexpr std::array<Object (*)(Random&), 7> kDraw = {drawClutterBall, drawClutterRod, drawCup, drawBowl,
                                                        drawClutterCone, drawPot,        drawBox};
  return kDraw[random.below(kDraw.size())](random);
}

namespace {

/// A box under the thing, wide enough for it.
Pile onABox(Object thing, Random& random) {
  const double turn = random.uniform(-8.0, 8.0) * kDegree;
  const double half_x = thing.half_line + thing.radius + random.uniform(0.003, 0.020);
  const double half_y = thing.half_line * std::sin(std::abs(turn)) + thing.radius + random.uniform(0.003, 0.020);
  const double half_z = random.uniform(0.012, 0.045);
  thing.pose = Eigen::Translation3d(0.0, 0.0, 2.0 * half_z) * Eigen::AngleAxisd(turn, Vec3::UnitZ()) * thing.pose;
  return {{"box", Box{half_x, half_y, half_z}, at(0.0, half_z), half_x, half_y}, thing};
}

}  // namespace

std::vector<Pile> drawPiles(Random& random) {
  const std::size_t count = 6 + random.below(9), shapeless = 1 + random.below(3);
  std::vector<Pile> piles;
  for (std::size_t drawn = 0; drawn < count; ++drawn) {
    const Object thing = drawn < shapeless ? drawShapeless(random) : drawPrimitive(random);
    const bool raised = drawn + 1 < count && oneIn(4, random);
    piles.push_back(raised ? onABox(thing, random) : Pile{thing});
    if (raised) ++drawn;  // the box
  }
  return piles;
}

}  // namespace primitect::synthetic
