// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Distances that ray tracing may go without stepping through; see soft_solids.h.
#include "synthetic/soft_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "synthetic/solid_limits.h"

namespace primitect::synthetic {
namespace {

/// To a sheet around a height field, cut out by an outline (already a distance or less): a height field that is nowhere
/// steeper than `steepest` is at least the vertical distance `above` it times a cosine away.
double sheetDistance(double above, double steepest, double thickness, double outline) {
  const double across = std::abs(above) / std::sqrt(1.0 + steepest * steepest) - 0.5 * thickness;
  return std::max(across, outline);
}

double limbDistance(const Limbs::Limb& limb, const Vec3& p) {
  const Vec3 line = limb.to - limb.from;
  const double along = std::clamp((p - limb.from).dot(line) / line.squaredNorm(), 0.0, 1.0);
  const double taper = limb.radius_to - limb.radius_from;
  const double away = (p - limb.from - along * line).norm() - limb.radius_from - along * taper;
  return away / std::sqrt(1.0 + taper * taper / line.squaredNorm());
}

/// The smaller one; where both are within `blend` of one another, up to blend / 4 less. No steeper than they are.
double smoothLess(double a, double b, double blend) {
  const double near = std::max(blend - std::abs(a - b), 0.0);
  return std::min(a, b) - (blend > 0.0 ? 0.25 * near * near / blend : 0.0);
}

}  // namespace

double Cloth::heightAt(double x, double y) const {
  double height = 0.0;
  for (const Wave& wave : waves) height += wave.height * std::sin(wave.along_x * x + wave.along_y * y + wave.phase);
  return height;
}

double Cloth::steepest() const {
  double sum = 0.0;
  for (const Wave& wave : waves) sum += wave.height * std::hypot(wave.along_x, wave.along_y);
  return sum;
}

double Cloth::highest() const {
  double sum = 0.5 * thickness * std::hypot(1.0, steepest());
  for (const Wave& wave : waves) sum += wave.height;
  return sum;
}

double Cloth::distanceTo(const Vec3& p) const {
  const double outline = std::max(std::abs(p.x()) - half_x, std::abs(p.y()) - half_y);
  return sheetDistance(p.z() - heightAt(p.x(), p.y()), steepest(), thickness, outline);
}

double Leaf::heightAt(double x, double y) const {
  // Beside the ellipse it goes on level: else it would become steeper and steeper.
  const double u = std::clamp(x / half_x, -1.0, 1.0), v = std::min(std::abs(y) / half_y, 1.0);
  return fold * v - bend * u * u;
}

double Leaf::steepest() const { return std::hypot(2.0 * bend / half_x, fold / half_y); }

double Leaf::highest() const {
  return std::max(std::abs(bend), std::abs(fold)) + 0.5 * thickness * std::hypot(1.0, steepest());
}

double Leaf::distanceTo(const Vec3& p) const {
  const double outline = (std::hypot(p.x() / half_x, p.y() / half_y) - 1.0) * std::min(half_x, half_y);
  return sheetDistance(p.z() - heightAt(p.x(), p.y()), steepest(), thickness, outline);
}

double Limbs::distanceTo(const Vec3& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Limb& limb : limbs) nearest = smoothLess(nearest, limbDistance(limb, p), blend);
  return nearest;
}

Limbs joined(std::vector<Limbs::Limb> limbs, double blend) {
  if (limbs.empty()) throw std::invalid_argument("limbs: there must be at least one");
  double reach = 0.0;
  for (const Limbs::Limb& limb : limbs) {
    reach = std::max({reach, limb.from.norm() + limb.radius_from, limb.to.norm() + limb.radius_to});
  }
  return {std::move(limbs), blend, reach + blend};
}

bool isPossible(const Cloth& cloth) {
  bool possible = isLength(cloth.half_x) && isLength(cloth.half_y) && isLength(cloth.thickness);
  for (const Cloth::Wave& wave : cloth.waves) {
    possible = possible && wave.height >= 0.0 && std::isfinite(wave.height + wave.along_x + wave.along_y + wave.phase);
  }
  return possible;
}

bool isPossible(const Leaf& leaf) {
  return isLength(leaf.half_x) && isLength(leaf.half_y) && isLength(leaf.thickness) &&
         std::isfinite(leaf.bend + leaf.fold);
}

bool isPossible(const Limbs& limbs) {
  bool possible = !limbs.limbs.empty() && limbs.blend >= 0.0 && isLength(limbs.reach);
  for (const Limbs::Limb& limb : limbs.limbs) {
    possible =
        possible && isLength(limb.radius_from) && isLength(limb.radius_to) && isLength((limb.to - limb.from).norm());
  }
  return possible;
}

}  // namespace primitect::synthetic
