// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Draws things and puts them close together, the circle that they must stay in growing until they fit.
#include "synthetic/clutter.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/random.h"
#include "synthetic/clutter_objects.h"
#include "synthetic/household_objects.h"
#include "synthetic/poses.h"
#include "synthetic/room.h"
#include "synthetic/scene_layout.h"
#include "synthetic/soft_objects.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic {
namespace {

constexpr double kWidestReach = 0.42;  // m, of the things' middles

/// Places for all piles, the first ones nearer to the middle, or none when they did not fit in.
std::optional<std::vector<Place>> drawPlaces(const std::vector<Pile>& piles, Random& random) {
  constexpr double kGap = 0.006;
  constexpr double kGrowth = 1.01;  // of the reach with every place that was taken
  std::vector<Place> places;
  double reach = 0.10;
  while (places.size() < piles.size()) {
    const double angle = random.uniform(0.0, 2.0 * kPi), radius = reach * std::sqrt(random.uniform());
    const Place place{{radius * std::cos(angle), radius * std::sin(angle)}, random.uniform(0.0, 2.0 * kPi)};
    bool is_free = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
      is_free = is_free && apart(piles[i].front(), places[i], piles[places.size()].front(), place, kGap);
    }
    if (is_free) places.push_back(place);
    if (!is_free) reach *= kGrowth;
    if (reach > kWidestReach) return std::nullopt;
  }
  return places;
}

World drawRoom(Random& random) {
  World world;
  addFloor(world);
  // Wide enough for the things at their widest reach and their own half length.
  const double half_x = random.uniform(0.62, 0.75), half_y = random.uniform(0.65, 0.90);
  if (random.below(4) == 0) {
    addWall(half_x + 0.01, 0.0, world);
  } else {
    addWall(random.uniform(2.4, 3.5), 0.0, world);
    const double side = random.below(2) == 0 ? kPi / 2 : -kPi / 2, away = random.uniform(2.8, 3.6);
    if (random.below(2) == 0) addWall(away, side, world);
  }
  addTable(half_x, half_y, world);
  return world;
}

/// A room with drawn things on its table.
World furnished(std::vector<Pile> (*draw)(Random&), std::uint64_t seed, Random& random) {
  constexpr int kTries = 100;
  World world = drawRoom(random);
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const std::vector<Pile> piles = draw(random);
    const std::optional<std::vector<Place>> places = drawPlaces(piles, random);
    if (!places) continue;
    for (std::size_t i = 0; i < piles.size(); ++i) {
      const Place& place = (*places)[i];
      const Eigen::Isometry3d stand(Eigen::Translation3d(place.center.x(), place.center.y(), kTableHeight) *
                                    Eigen::AngleAxisd(place.yaw, Vec3::UnitZ()));
      for (const Object& object : piles[i]) world.add(object.name, object.solid, stand * object.pose);
    }
    return world;
  }
  throw std::runtime_error("cluttered table: found no room for the things of seed " + std::to_string(seed));
}

}  // namespace

World clutteredTable(std::uint64_t seed) {
  Random random(2 * seed);
  return furnished(drawPiles, seed, random);
}

World shapelessTable(std::uint64_t seed) {
  Random random((2 * seed) ^ 0x736f6674U);
  return furnished(drawSoftPiles, seed, random);
}

World householdTable(std::uint64_t seed) {
  Random random((2 * seed) ^ 0x686f6d65U);
  return furnished(drawHouseholdPiles, seed, random);
}

Eigen::Isometry3d clutterPose(std::uint64_t seed) {
  Random random(2 * seed + 1);
  const double x = random.uniform(-0.05, 0.05), y = random.uniform(-0.05, 0.05);
  const Vec3 target(x, y, kTableHeight + 0.04);
  const double yaw = random.uniform(-50.0, 50.0) * kDegree, pitch = random.uniform(25.0, 55.0) * kDegree;
  const double distance = random.uniform(0.8, 1.3), roll = random.uniform(-5.0, 5.0) * kDegree;
  const Vec3 backwards(-std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch));
  return lookAt(target + distance * backwards, target) * Eigen::AngleAxisd(roll, Vec3::UnitZ());
}

}  // namespace primitect::synthetic
