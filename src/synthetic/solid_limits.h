// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which lengths and angles solids may have; those of soft_solids.h tell it themselves.
#pragma once

#include <cmath>

#include "synthetic/world.h"

namespace primitect::synthetic {

constexpr double kHalfPi = 1.57079632679489661923;

/// Written so that NaN and infinity fail.
inline bool isLength(double value) { return value > 0.0 && std::isfinite(value); }

inline bool isPossible(const Sheet& s) { return isLength(s.half_x) && isLength(s.half_y); }
inline bool isPossible(const Box& b) { return isLength(b.half_x) && isLength(b.half_y) && isLength(b.half_z); }
inline bool isPossible(const Ball& b) { return isLength(b.radius); }
inline bool isPossible(const Rod& r) { return isLength(r.radius) && isLength(r.half_length); }
inline bool isPossible(const Frustum& f) {
  return f.half_angle > 0.0 && f.half_angle < kHalfPi && f.begin >= 0.0 && f.begin < f.end && isLength(f.end);
}
inline bool isPossible(const Cup& c) {
  return isLength(c.inner_radius) && c.inner_radius < c.radius && isLength(c.radius) && isLength(c.half_length) &&
         c.base > 0.0 && c.base < 2.0 * c.half_length;
}
inline bool isPossible(const Pot& p) {
  return isPossible(Frustum{p.half_angle, p.begin, p.end}) && p.begin > 0.0 && p.wall > 0.0 && p.floor > p.begin &&
         p.floor > p.innerApex() && p.floor < p.end;
}
inline bool isPossible(const Bowl& b) {
  return isLength(b.inner_radius) && b.inner_radius < b.radius && isLength(b.radius) &&
         std::abs(b.rim) < b.inner_radius && b.foot > -b.radius && b.foot < -b.inner_radius;
}
inline bool isPossible(const Ellipsoid& e) { return isLength(e.half_x) && isLength(e.half_y) && isLength(e.half_z); }
inline bool isPossible(const Torus& t) {
  return isLength(t.ring_radius) && t.tube_radius > 0.0 && t.tube_radius < t.ring_radius;
}
inline bool isPossible(const Lump& l) {
  return isLength(l.radius) && l.bump > 0.0 && l.bump <= 0.3 && isLength(l.frequency) && std::isfinite(l.phase);
}

}  // namespace primitect::synthetic
