// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Things are dropped straight down until they touch: rays from below and from above tell how far they fall.
#include "synthetic/heap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/random.h"
#include "synthetic/clutter_objects.h"
#include "synthetic/intersections.h"
#include "synthetic/intersections_hollow.h"
#include "synthetic/intersections_traced.h"
#include "synthetic/poses.h"
#include "synthetic/room.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic {
namespace {

constexpr double kFar = 3.0;  // m, above and below everything

/// Height of the body's first point on a vertical line through (x, y), from above or from below; none: it misses.
std::optional<double> heightAt(const Body& body, double x, double y, bool from_above) {
  const double start = from_above ? kFar : -kFar;
  const Eigen::Isometry3d body_from_world = body.world_from_body.inverse();
  const Vec3 origin = body_from_world * Vec3(x, y, start);
  const Vec3 direction = body_from_world.linear() * Vec3(0.0, 0.0, from_above ? -1.0 : 1.0);
  const Hit hit = std::visit([&](const auto& solid) { return intersect(solid, origin, direction); }, body.solid);
  if (!(hit.t > 0.0)) return std::nullopt;
  return from_above ? start - hit.t : start + hit.t;
}

/// Half of the diagonal of the body's bounding box: it is within this of its middle.
double reachOf(const Body& body) { return 0.5 * (body.corner_max - body.corner_min).norm(); }

Vec3 middleOf(const Body& body) { return body.world_from_body * (0.5 * (body.corner_min + body.corner_max)); }

/// How far the last body falls (m) until it touches the table or one of those before it from `first` on.
double fallOfLast(const World& world, std::size_t first) {
  constexpr double kStep = 0.004;
  const Body& body = world.bodies().back();
  const Vec3 middle = middleOf(body);
  const double reach = reachOf(body);
  std::vector<const Body*> near;
  for (std::size_t i = first; i + 1 < world.bodies().size(); ++i) {
    const Body& other = world.bodies()[i];
    if ((middleOf(other) - middle).head<2>().norm() <= reach + reachOf(other)) near.push_back(&other);
  }
  double fall = std::numeric_limits<double>::infinity();
  for (double x = middle.x() - reach; x <= middle.x() + reach; x += kStep) {
    for (double y = middle.y() - reach; y <= middle.y() + reach; y += kStep) {
      const std::optional<double> bottom = heightAt(body, x, y, false);
      if (!bottom) continue;
      double ground = kTableHeight;
      for (const Body* other : near) {
        if (const std::optional<double> top = heightAt(*other, x, y, true)) ground = std::max(ground, *top);
      }
      fall = std::min(fall, *bottom - ground);
    }
  }
  return fall;
}

/// Above the table; half of them turned anyhow, the others as they stand or lie.
Eigen::Isometry3d drawPose(const Object& thing, double reach, Random& random) {
  constexpr double kHigh = 2.0;  // m
  const double angle = random.uniform(0.0, 2.0 * kPi), away = reach * std::sqrt(random.uniform());
  const double yaw = random.uniform(0.0, 2.0 * kPi), tilt = std::acos(random.uniform(-1.0, 1.0));
  const double spin = random.uniform(0.0, 2.0 * kPi);
  const Eigen::Isometry3d place(Eigen::Translation3d(away * std::cos(angle), away * std::sin(angle), kHigh) *
                                Eigen::AngleAxisd(yaw, Vec3::UnitZ()));
  if (random.below(2) == 0) return place * Eigen::Isometry3d(thing.pose.linear());
  return place * tilted(tilt) * Eigen::AngleAxisd(spin, Vec3::UnitZ());
}

/// Adds the thing where, of some places, its middle comes to lie lowest.
void drop(const Object& thing, double reach, std::size_t first, Random& random, World& world) {
  constexpr int kPlaces = 8;
  double lowest = std::numeric_limits<double>::infinity();
  Eigen::Isometry3d best;
  for (int place = 0; place < kPlaces; ++place) {
    const Eigen::Isometry3d above = drawPose(thing, reach, random);
    World trial = world;
    trial.add(thing.name, thing.solid, above);
    const double fall = fallOfLast(trial, first);
    const double height = middleOf(trial.bodies().back()).z() - fall;
    if (height >= lowest) continue;
    lowest = height;
    best = Eigen::Translation3d(0.0, 0.0, -fall) * above;
  }
  world.add(thing.name, thing.solid, best);
}

}  // namespace

World heap(std::uint64_t seed) {
  Random random((2 * seed) ^ 0x68656170U);
  World world;
  addFloor(world);
  addTable(0.7, 0.8, world);
  const std::size_t first = world.bodies().size();
  const std::size_t count = 12 + random.below(17), shapeless = random.below(3);
  const double reach = random.uniform(0.12, 0.25);
  for (std::size_t i = 0; i < count; ++i) {
    const Object thing = i < shapeless ? drawShapeless(random) : drawPrimitive(random);
    drop(thing, reach, first, random, world);
  }
  return world;
}

}  // namespace primitect::synthetic
