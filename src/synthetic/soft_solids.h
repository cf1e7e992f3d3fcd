// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cloth, leaves, cables and hands: solids in their own frame whose surface is none of the four kinds. Each tells a
// distance that is never more than that to its surface, negative inside; lengths in m.
#pragma once

#include <array>
#include <vector>

#include "primitect/primitives.h"

namespace primitect::synthetic {

/// A cloth around the plane z = 0 with three crossing waves: its middle is at z = sum of height * sin(direction . (x,
/// y)
/// + phase), and it is as thick as given where it is steepest, thicker elsewhere. Surface: 0.
struct Cloth {
  struct Wave {
    double along_x, along_y;  ///< rad / m
    double height, phase;     ///< m, rad
  };
  double half_x, half_y, thickness;
  std::array<Wave, 3> waves;
  double heightAt(double x, double y) const;
  double steepest() const;  ///< no slope is larger
  double highest() const;   ///< no point's |z| is larger
  double distanceTo(const Vec3& p) const;
};

/// A leaf around the origin, an ellipse from above: bent along x by `bend` (m, at its ends), folded along y = 0 by
/// `fold` (m, at its sides); thickness as of a cloth. Surface: 0.
struct Leaf {
  double half_x, half_y, thickness, bend, fold;
  double heightAt(double x, double y) const;
  double steepest() const;
  double highest() const;
  double distanceTo(const Vec3& p) const;
};

/// Limbs that flow into one another: round rods whose radius changes evenly from one end to the other. A cable is a
/// row of thin ones, a hand has five fingers and a palm. Surface: 0.
struct Limbs {
  struct Limb {
    Vec3 from, to;
    double radius_from, radius_to;
  };
  std::vector<Limb> limbs;
  double blend;  ///< width of the transition between limbs; 0: none
  double reach;  ///< within this ball around the origin
  double distanceTo(const Vec3& p) const;
};

/// Limbs with their reach. Throws std::invalid_argument without limbs.
Limbs joined(std::vector<Limbs::Limb> limbs, double blend);

/// Written so that NaN fails.
bool isPossible(const Cloth& cloth);
bool isPossible(const Leaf& leaf);
bool isPossible(const Limbs& limbs);

}  // namespace primitect::synthetic
