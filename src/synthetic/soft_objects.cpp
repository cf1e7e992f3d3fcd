// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sizes and poses of cloths, cables, plants and hands.
#include "synthetic/soft_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "synthetic/poses.h"

namespace primitect::synthetic {
namespace {

/// Waves of 5 to 20 cm, each in its own direction: no fold is straight for long.
Pile drawCloth(Random& random) {
  Cloth cloth{random.uniform(0.09, 0.15), random.uniform(0.07, 0.12), 0.002, {}};
  for (int k = 0; k < 3; ++k) {
    const double length = random.uniform(0.05, 0.20), heading = (60.0 * k + random.uniform(0.0, 60.0)) * kDegree;
    const double turn = 2.0 * kPi / length;
    cloth.waves[k] = {turn * std::cos(heading), turn * std::sin(heading), length * random.uniform(0.04, 0.08),
                      random.uniform(0.0, 2.0 * kPi)};
  }
  return {{"cloth", cloth, at(0.0, cloth.highest()), 0.0, std::hypot(cloth.half_x, cloth.half_y)}};
}

/// Lies on the table, 15 to 30 cm long, and bends to and fro.
Pile drawCable(Random& random) {
  constexpr int kPieces = 20;
  const double radius = random.uniform(0.003, 0.007), step = random.uniform(0.15, 0.30) / kPieces;
  const double bend = random.uniform(8.0, 25.0) * kDegree, period = random.uniform(8.0, 20.0);
  double heading = 0.0;
  std::vector<Vec3> line = {Vec3::Zero()};
  Vec3 middle = Vec3::Zero();
  for (int k = 1; k <= kPieces; ++k) {
    heading += bend * std::sin(2.0 * kPi * k / period);
    line.push_back(line.back() + step * Vec3(std::cos(heading), std::sin(heading), 0.0));
    middle += line.back() / kPieces;
  }
  std::vector<Limbs::Limb> pieces;
  for (int k = 0; k < kPieces; ++k) pieces.push_back({line[k] - middle, line[k + 1] - middle, radius, radius});
  const Limbs cable = joined(std::move(pieces), 0.0);
  return {{"cable", cable, at(0.0, radius), 0.0, cable.reach}};
}

/// Leaves around and above a box, the higher ones nearer to the middle.
Pile drawPlant(Random& random) {
  constexpr double kReach = 0.10;
  const double half = random.uniform(0.025, 0.035), top = 2.0 * half;
  Pile plant = {{"box", Box{half, half, half}, at(0.0, half), 0.0, kReach + 0.03}};
  const int leaves = 24 + static_cast<int>(random.below(16));
  for (int k = 0; k < leaves; ++k) {
    const double share = (k + random.uniform()) / leaves, around = random.uniform(0.0, 2.0 * kPi);
    const Leaf leaf{random.uniform(0.018, 0.035), random.uniform(0.009, 0.016), 0.001, random.uniform(0.002, 0.008),
                    random.uniform(0.001, 0.006)};
    const double out = kReach * (1.0 - 0.7 * share) * std::sqrt(random.uniform(0.1, 1.0));
    const double roll = random.uniform(-40.0, 40.0) * kDegree, pitch = random.uniform(-20.0, 70.0) * kDegree;
    const Eigen::Isometry3d pose = Eigen::Translation3d(0.0, 0.0, top + 0.03 + 0.14 * share) *
                                   Eigen::AngleAxisd(around, Vec3::UnitZ()) * Eigen::Translation3d(out, 0.0, 0.0) *
                                   Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
                                   Eigen::Isometry3d(Eigen::AngleAxisd(roll, Vec3::UnitX()));
    plant.push_back({"leaf", leaf, pose, 0.0, leaf.half_x});
  }
  return plant;
}

/// Two bent pieces from the knuckle on, tapered, its tip on the table.
void addFinger(const Vec3& knuckle, double heading, double length, double radius, std::vector<Limbs::Limb>& limbs) {
  const Vec3 ahead(std::cos(heading), std::sin(heading), 0.0);
  const Vec3 tip = knuckle + length * ahead;
  const Vec3 joint = knuckle + 0.55 * length * ahead + Vec3(0.0, 0.0, 0.012);
  limbs.push_back({knuckle, joint, radius, 0.92 * radius});
  limbs.push_back({joint, Vec3(tip.x(), tip.y(), 0.8 * radius), 0.92 * radius, 0.75 * radius});
}

/// A hand lying on the table, its fingers spread a little.
Pile drawHand(Random& random) {
  const double scale = random.uniform(0.85, 1.1), spread = random.uniform(4.0, 12.0) * kDegree;
  std::vector<Limbs::Limb> limbs;
  constexpr std::array<double, 4> kLengths = {0.068, 0.078, 0.074, 0.058};
  for (int k = 0; k < 4; ++k) {
    const double side = k - 1.5;
    const Vec3 wrist(-0.045, 0.010 * side, 0.022), knuckle(0.038, 0.021 * side, 0.024);
    limbs.push_back({scale * wrist, scale * knuckle, 0.016 * scale, 0.013 * scale});
    const double heading = -spread * side + random.uniform(-3.0, 3.0) * kDegree;
    addFinger(scale * knuckle, -heading, scale * kLengths[k], 0.0095 * scale, limbs);
  }
  const Vec3 thumb_root(-0.030, -0.026, 0.020);
  addFinger(scale * thumb_root, -random.uniform(35.0, 60.0) * kDegree, 0.070 * scale, 0.012 * scale, limbs);
  const Limbs hand = joined(std::move(limbs), 0.010);
  return {{"hand", hand, at(0.0, 0.002), 0.03, 0.11 * scale}};
}

}  // namespace

std::vector<Pile> drawSoftPiles(Random& random) {
  constexpr std::array<Pile (*)(Random&), 4> kDraw = {drawCloth, drawCable, drawPlant, drawHand};
  const std::size_t soft = 3 + random.below(3), first = random.below(kDraw.size());
  const std::size_t round = 2 + random.below(3), boxes = 2 + random.below(3);
  std::vector<Pile> piles;
  for (std::size_t k = 0; k < soft; ++k) piles.push_back(kDraw[(first + k) % kDraw.size()](random));
  for (std::size_t k = 0; k < round; ++k) piles.push_back({drawShapeless(random)});
  for (std::size_t k = 0; k < boxes; ++k) piles.push_back({drawBox(random)});
  return piles;
}

}  // namespace primitect::synthetic
