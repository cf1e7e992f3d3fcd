// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a ray meets a hollow solid: every face for itself, the nearest hit counts.
#pragma once

#include <cmath>

#include "synthetic/intersections.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

/// A face of revolution around z: which, and between which heights.
struct Band {
  int face;
  double low, high;
};

/// A ray and its nearest hit so far.
class NearestHit {
 public:
  NearestHit(const Vec3& origin, const Vec3& direction) : origin_(origin), direction_(direction) {}

  Hit hit() const { return hit_.t < kNone ? hit_ : Hit{}; }

  void cylinder(double radius, const Band& band) {
    const auto o = origin_.head<2>(), d = direction_.head<2>();
    roots(d.squaredNorm(), o.dot(d), o.squaredNorm() - radius * radius, band);
  }

  /// slope: tangent of the half angle; apex: its height.
  void cone(double slope, double apex, const Band& band) {
    const auto o = origin_.head<2>(), d = direction_.head<2>();
    const double height = slope * (origin_.z() - apex), climb = slope * direction_.z();
    roots(d.squaredNorm() - climb * climb, o.dot(d) - height * climb, o.squaredNorm() - height * height, band);
  }

  void sphere(double radius, const Band& band) {
    roots(direction_.squaredNorm(), origin_.dot(direction_), origin_.squaredNorm() - radius * radius, band);
  }

  /// A disc at this height with a hole (inner_radius 0: without).
  void ring(double height, double inner_radius, double radius, int face) {
    const double t = (height - origin_.z()) / direction_.z();
    const double radius_sq = (origin_.head<2>() + t * direction_.head<2>()).squaredNorm();
    if (radius_sq >= inner_radius * inner_radius && radius_sq <= radius * radius) take(t, face);
  }

 private:
  static constexpr double kNone = 1e300;

  void take(double t, int face) {
    if (t > 0.0 && t < hit_.t) hit_ = {t, face};
  }

  /// Both roots of a t^2 + 2 half_b t + c without cancellation; where there is no second one it is infinite or NaN,
  /// which no comparison takes.
  void roots(double a, double half_b, double c, const Band& band) {
    const double discriminant = half_b * half_b - a * c;
    if (discriminant < 0.0) return;
    const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    for (const double t : {q / a, c / q}) {
      const double height = origin_.z() + t * direction_.z();
      if (height >= band.low && height <= band.high) take(t, band.face);
    }
  }

  const Vec3& origin_;
  const Vec3& direction_;
  Hit hit_{kNone, 0};
};

inline Hit intersect(const Cup& cup, const Vec3& origin, const Vec3& direction) {
  NearestHit nearest(origin, direction);
  const double bottom = -cup.half_length, top = cup.half_length, inside_bottom = bottom + cup.base;
  nearest.cylinder(cup.radius, {0, bottom, top});
  nearest.ring(bottom, 0.0, cup.radius, 1);
  nearest.ring(top, cup.inner_radius, cup.radius, 2);
  nearest.cylinder(cup.inner_radius, {3, inside_bottom, top});
  nearest.ring(inside_bottom, 0.0, cup.inner_radius, 4);
  return nearest.hit();
}

inline Hit intersect(const Pot& pot, const Vec3& origin, const Vec3& direction) {
  NearestHit nearest(origin, direction);
  const double slope = std::tan(pot.half_angle), inner_apex = pot.innerApex();
  nearest.cone(slope, 0.0, {0, pot.begin, pot.end});
  nearest.ring(pot.begin, 0.0, pot.begin * slope, 1);
  nearest.ring(pot.end, (pot.end - inner_apex) * slope, pot.end * slope, 2);
  nearest.cone(slope, inner_apex, {3, pot.floor, pot.end});
  nearest.ring(pot.floor, 0.0, (pot.floor - inner_apex) * slope, 4);
  return nearest.hit();
}

inline Hit intersect(const Bowl& bowl, const Vec3& origin, const Vec3& direction) {
  NearestHit nearest(origin, direction);
  const auto width = [](double radius, double height) { return std::sqrt(radius * radius - height * height); };
  nearest.sphere(bowl.radius, {0, bowl.foot, bowl.rim});
  nearest.sphere(bowl.inner_radius, {1, -bowl.inner_radius, bowl.rim});
  nearest.ring(bowl.rim, width(bowl.inner_radius, bowl.rim), width(bowl.radius, bowl.rim), 2);
  nearest.ring(bowl.foot, 0.0, width(bowl.radius, bowl.foot), 3);
  return nearest.hit();
}

}  // namespace primitect::synthetic
