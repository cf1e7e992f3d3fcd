// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Jars, bottles, pots and tins are turned: parts around one axis, put on one another.
#include "synthetic/household_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "synthetic/chance.h"
#include "synthetic/poses.h"

namespace primitect::synthetic {
namespace {

/// A thing of parts around z, built from the bottom; lengths in m.
class Turned {
 public:
  void addRod(const char* name, double radius, double height) {
    add(name, Rod{radius, 0.5 * height}, at(0.0, height_ + 0.5 * height), radius, height);
  }

  /// A part that becomes narrower or wider towards its top.
  void addTaper(const char* name, double bottom, double top, double height) {
    const double half_angle = std::atan2(std::abs(bottom - top), height);
    const double narrow = std::min(bottom, top) / std::tan(half_angle);
    const Frustum frustum{half_angle, narrow, narrow + height};
    // The apex is below what becomes wider, above what becomes narrower.
    const Eigen::Isometry3d pose =
        top > bottom ? at(0.0, height_ - frustum.begin) : at(0.0, height_ + frustum.end) * tilted(kPi);
    add(name, frustum, pose, std::max(bottom, top), height);
  }

  Pile standing() const {
    Pile pile = parts_;
    pile.front().radius = widest_;
    return pile;
  }

  /// On the side, its widest part on the table.
  Pile lying() const {
    Pile pile = parts_;
    for (Object& part : pile) part.pose = at(0.0, widest_) * tilted(kPi / 2) * at(0.0, -0.5 * height_) * part.pose;
    pile.front().half_line = 0.5 * height_;
    pile.front().radius = widest_;
    return pile;
  }

  Pile standingOrLying(Random& random) const { return oneIn(4, random) ? lying() : standing(); }

 private:
  void add(const char* name, const Solid& solid, const Eigen::Isometry3d& pose, double widest, double height) {
    parts_.push_back({name, solid, pose, 0.0, widest});
    widest_ = std::max(widest_, widest);
    height_ += height;
  }

  Pile parts_;
  double height_ = 0.0, widest_ = 0.0;
};

/// Body, shoulder, and a lid a little wider than the neck that it hides.
Pile drawJar(Random& random) {
  const double radius = random.uniform(0.032, 0.055), neck = radius * random.uniform(0.75, 0.9);
  Turned jar;
  jar.addRod("jar", radius, random.uniform(0.05, 0.12));
  jar.addTaper("shoulder", radius, neck, random.uniform(0.006, 0.020));
  jar.addRod("lid", std::min(neck + 0.002, radius - 0.003), random.uniform(0.010, 0.020));
  return jar.standingOrLying(random);
}

Pile drawBottle(Random& random) {
  const double radius = random.uniform(0.028, 0.045), neck = random.uniform(0.012, 0.016);
  Turned bottle;
  bottle.addRod("bottle", radius, random.uniform(0.09, 0.17));
  bottle.addTaper("shoulder", radius, neck, random.uniform(0.025, 0.060));
  bottle.addRod("neck", neck, random.uniform(0.015, 0.050));
  bottle.addRod("lid", neck + 0.002, random.uniform(0.012, 0.020));
  return bottle.standingOrLying(random);
}

Pile drawSprayCan(Random& random) {
  const double radius = random.uniform(0.024, 0.034), top = radius * random.uniform(0.65, 0.8);
  Turned can;
  can.addRod("spray can", radius, random.uniform(0.11, 0.18));
  can.addTaper("shoulder", radius, top, random.uniform(0.008, 0.018));
  can.addRod("lid", top, random.uniform(0.020, 0.045));
  return can.standingOrLying(random);
}

/// With a rim that is wider than what it is the rim of.
Pile drawFlowerPot(Random& random) {
  const double half_angle = random.uniform(6.5, 14.0) * kDegree, height = random.uniform(0.06, 0.13);
  const double top = random.uniform(0.045, 0.085), rim = top + random.uniform(0.003, 0.006);
  Turned pot;
  pot.addTaper("flower pot", top - height * std::tan(half_angle), top, height);
  pot.addRod("rim", rim, random.uniform(0.015, 0.030));
  return pot.standing();
}

/// Its lid hardly wider than itself, and too flat to be told from it.
Pile drawTin(Random& random) {
  const double radius = random.uniform(0.055, 0.100), lid = radius + random.uniform(0.001, 0.002);
  Turned tin;
  tin.addRod("tin", radius, random.uniform(0.035, 0.080));
  tin.addRod("lid", lid, random.uniform(0.004, 0.007));
  return tin.standing();
}

/// Two, seldom three, each wider or narrower than the one below by 4 mm or more, and not quite over its middle.
Pile drawCans(Random& random) {
  constexpr double kApart = 0.004, kAside = 0.0015;
  const int count = oneIn(4, random) ? 3 : 2;
  Turned cans;
  double below = 0.0;
  for (int k = 0; k < count; ++k) {
    double radius = below;
    while (std::abs(radius - below) < kApart) radius = random.uniform(0.032, 0.054);
    cans.addRod("can", radius, random.uniform(0.045, 0.100));
    below = radius;
  }
  Pile pile = cans.standing();
  for (Object& can : pile) {
    const double x = random.uniform(-kAside, kAside), y = random.uniform(-kAside, kAside);
    can.pose = Eigen::Translation3d(x, y, 0.0) * can.pose;
  }
  pile.front().radius += 2.0 * kAside;
  return pile;
}

/// Two to five, each turned and moved a little.
Pile drawBooks(Random& random) {
  const std::size_t count = 2 + random.below(4);
  Pile pile;
  double height = 0.0, reach = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const Box book{random.uniform(0.075, 0.12), random.uniform(0.055, 0.085), 0.5 * random.uniform(0.010, 0.040)};
    const double x = random.uniform(-0.012, 0.012), y = random.uniform(-0.012, 0.012);
    const double turn = random.uniform(-12.0, 12.0) * kDegree;
    const Eigen::Isometry3d pose(Eigen::Translation3d(x, y, height + book.half_z) *
                                 Eigen::AngleAxisd(turn, Vec3::UnitZ()));
    pile.push_back({"book", book, pose, 0.0, 0.0});
    height += 2.0 * book.half_z;
    reach = std::max(reach, std::hypot(book.half_x, book.half_y) + std::hypot(x, y));
  }
  pile.front().radius = reach;
  return pile;
}

/// A cup whose handle stands out to +x; the handle's ends are in the wall.
Pile drawMug(Random& random) {
  const double radius = random.uniform(0.036, 0.048), half = random.uniform(0.038, 0.055);
  const double wall = random.uniform(0.0035, 0.005), thick = random.uniform(0.0035, 0.005);
  const double out = random.uniform(0.020, 0.030), low = -0.6 * half, high = 0.6 * half;
  const double begin = radius + 0.5 * thick;  // of the middle line: the rest is outside of the inner wall
  const std::array<Vec3, 4> line = {Vec3(begin, 0.0, low), Vec3(begin + out, 0.0, 0.6 * low),
                                    Vec3(begin + out, 0.0, 0.6 * high), Vec3(begin, 0.0, high)};
  std::vector<Limbs::Limb> limbs;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) limbs.push_back({line[k], line[k + 1], thick, thick});
  const double widest = begin + out + thick;
  return {{"mug", Cup{radius, radius - wall, half, wall}, at(0.0, half), 0.0, widest},
          {"handle", joined(std::move(limbs), 0.0), at(0.0, half), 0.0, widest}};
}

}  // namespace

std::vector<Pile> drawHouseholdPiles(Random& random) {
  constexpr std::array<Pile (*)(Random&), 8> kDraw = {drawJar, drawBottle, drawSprayCan, drawFlowerPot,
                                                      drawTin, drawCans,   drawBooks,    drawMug};
  const std::size_t count = 6 + random.below(6);
  std::vector<Pile> piles;
  for (std::size_t k = 0; k < count; ++k) {
    piles.push_back(k % 3 == 2 ? Pile{drawPrimitive(random)} : kDraw[random.below(kDraw.size())](random));
  }
  return piles;
}

}  // namespace primitect::synthetic
