// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Draws large things and places for them on the floor.
#include "synthetic/hall.h"

#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "synthetic/clutter_objects.h"
#include "synthetic/poses.h"
#include "synthetic/room.h"
#include "synthetic/scene_layout.h"

namespace primitect::synthetic {
namespace {

Pile drawTrafficCone(Random& random) {
  const double half_angle = random.uniform(8.0, 18.0) * kDegree, height = random.uniform(0.23, 0.75);
  const double top = random.uniform(0.015, 0.03), foot = random.uniform(0.015, 0.03);
  const double begin = top / std::tan(half_angle), end = begin + height, radius = end * std::tan(half_angle);
  const double half = radius + random.uniform(0.01, 0.05);
  return {{"foot", Box{half, half, foot / 2}, at(0.0, foot / 2), 0.0, half * std::sqrt(2.0)},
          {"cone", Frustum{half_angle, begin, end}, at(0.0, foot + end) * tilted(kPi), 0.0, radius}};
}

Pile drawHallBall(Random& random) {
  const double radius = random.uniform(0.06, 0.20);
  return {{"sphere", Ball{radius}, at(0.0, radius), 0.0, radius}};
}

Pile drawBin(Random& random) {
  constexpr double kWall = 0.004;
  const double radius = random.uniform(0.10, 0.25), half = random.uniform(0.12, 0.35);
  return {{"bin", Cup{radius, radius - kWall, half, kWall}, at(0.0, half), 0.0, radius}};
}

Pile drawPillar(Random& random) {
  constexpr double kHalf = 1.3;
  const double radius = random.uniform(0.04, 0.25);
  return {{"pillar", Rod{radius, kHalf}, at(0.0, kHalf), 0.0, radius}};
}

Pile drawTube(Random& random) {
  const double radius = random.uniform(0.04, 0.15), half = random.uniform(0.2, 0.5);
  return {{"tube", Rod{radius, half}, at(0.0, radius) * tilted(kPi / 2), half, radius}};
}

Pile drawCrate(Random& random) {
  const double x = random.uniform(0.10, 0.30), y = random.uniform(0.08, x), z = random.uniform(0.08, 0.3);
  return {{"crate", Box{x, y, z}, at(0.0, z), x, y}};
}

/// An ellipsoid or a lump.
Pile drawFormless(Random& random) {
  const double half = random.uniform(0.12, 0.30);
  if (random.below(2) == 0) {
    return {{"ellipsoid", Ellipsoid{half, 0.65 * half, 0.45 * half}, at(0.0, 0.45 * half), 0.0, half}};
  }
  const Lump lump{half, random.uniform(0.15, 0.30), random.uniform(4.0, 7.0), random.uniform(0.0, 2.0 * kPi)};
  const double reach = half * (1.0 + lump.bump);
  return {{"lump", lump, at(0.0, reach), 0.0, reach}};
}

/// Traffic cones are as likely as two others together.
Pile drawThing(Random& random) {
  constexpr std::array<Pile (*)(Random&), 8> kDraw = {drawTrafficCone, drawTrafficCone, drawHallBall, drawBin,
                                                      drawPillar,      drawTube,        drawCrate,    drawFormless};
  return kDraw[random.below(kDraw.size())](random);
}

/// Across x, and turned from there about z by nearly this (rad).
void drawWall(double yaw, Random& random, World& world) {
  const double away = random.uniform(1.8, 3.0), turn = yaw + random.uniform(-0.3, 0.3);
  addWall(away, turn, world);
}

}  // namespace

World hall(std::uint64_t seed) {
  constexpr int kTries = 400;
  constexpr double kGap = 0.02;  // m
  Random random((2 * seed) ^ 0x68616c6cU);
  World world;
  addFloor(world);
  drawWall(0.0, random, world);
  drawWall(kPi / 2, random, world);
  const std::size_t count = 4 + random.below(6);
  std::vector<Object> placed;
  std::vector<Place> places;
  for (int attempt = 0; attempt < kTries && placed.size() < count; ++attempt) {
    const Pile thing = drawThing(random);
    const double x = random.uniform(-0.2, 1.0), y = random.uniform(-0.8, 0.8);
    const Place place{{x, y}, random.uniform(0.0, 2.0 * kPi)};
    bool is_free = true;
    for (std::size_t i = 0; i < placed.size(); ++i) {
      is_free = is_free && apart(placed[i], places[i], thing.front(), place, kGap);
    }
    if (!is_free) continue;
    placed.push_back(thing.front());
    places.push_back(place);
    const Eigen::Isometry3d stand(Eigen::Translation3d(x, y, 0.0) * Eigen::AngleAxisd(place.yaw, Vec3::UnitZ()));
    for (const Object& object : thing) world.add(object.name, object.solid, stand * object.pose);
  }
  return world;
}

Eigen::Isometry3d hallPose(std::uint64_t seed) {
  Random random((2 * seed + 1) ^ 0x68616c6cU);
  const double height = random.uniform(0.3, 1.2), down = random.uniform(5.0, 35.0) * kDegree;
  const double yaw = random.uniform(-0.2, 0.2), x = random.uniform(-1.3, -1.0), y = random.uniform(-0.2, 0.2);
  const Vec3 eye(x, y, height);
  const Vec3 ahead(std::cos(down) * std::cos(yaw), std::cos(down) * std::sin(yaw), -std::sin(down));
  return lookAt(eye, eye + ahead);
}

}  // namespace primitect::synthetic
