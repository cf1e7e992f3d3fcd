// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the tests know about solids, worked out apart from the code they test: inside, lowest point, surface points.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

/// Solid test by its definition, in the solid's frame; a sheet has no inside.
struct Contains {
  Vec3 p;
  double radial() const { return std::hypot(p.x(), p.y()); }
  bool operator()(const Sheet&) const { return false; }
  bool operator()(const Box& b) const {
    return std::abs(p.x()) < b.half_x && std::abs(p.y()) < b.half_y && std::abs(p.z()) < b.half_z;
  }
  bool operator()(const Ball& b) const { return p.norm() < b.radius; }
  bool operator()(const Rod& r) const { return radial() < r.radius && std::abs(p.z()) < r.half_length; }
  bool operator()(const Frustum& f) const {
    return p.z() > f.begin && p.z() < f.end && std::atan2(radial(), p.z()) < f.half_angle;
  }
  bool operator()(const Cup& c) const {
    const bool hollow = radial() <= c.inner_radius && p.z() >= c.base - c.half_length;
    return (*this)(Rod{c.radius, c.half_length}) && !hollow;
  }
  bool operator()(const Pot& c) const {
    // Across the mantle, seen from the apex of the outer cone, the wall begins at this distance from the inner one.
    const double depth = p.z() * std::sin(c.half_angle) - radial() * std::cos(c.half_angle);
    return (*this)(Frustum{c.half_angle, c.begin, c.end}) && (depth < c.wall || p.z() < c.floor);
  }
  bool operator()(const Bowl& b) const {
    return p.norm() < b.radius && p.norm() > b.inner_radius && p.z() < b.rim && p.z() > b.foot;
  }
  bool operator()(const Ellipsoid& e) const { return p.cwiseQuotient(Vec3(e.half_x, e.half_y, e.half_z)).norm() < 1.0; }
  bool operator()(const Torus& t) const {
    const Vec3 on_ring = t.ring_radius * Vec3(p.x(), p.y(), 0.0).normalized();
    return (p - on_ring).norm() < t.tube_radius;
  }
  bool operator()(const Lump& l) const { return p.norm() < l.reach(p.normalized()); }
  bool operator()(const Cloth& c) const {
    return std::abs(p.x()) < c.half_x && std::abs(p.y()) < c.half_y &&
           withinSheet(c.heightAt(p.x(), p.y()), c.thickness, c.steepest());
  }
  bool operator()(const Leaf& l) const {
    return std::hypot(p.x() / l.half_x, p.y() / l.half_y) < 1.0 &&
           withinSheet(l.heightAt(p.x(), p.y()), l.thickness, l.steepest());
  }
  /// Without the transitions between limbs, which only add to the body.
  bool operator()(const Limbs& l) const {
    return std::any_of(l.limbs.begin(), l.limbs.end(), [this](const Limbs::Limb& limb) {
      const Vec3 line = limb.to - limb.from;
      const double along = std::clamp((p - limb.from).dot(line) / line.squaredNorm(), 0.0, 1.0);
      return (p - limb.from - along * line).norm() < (1.0 - along) * limb.radius_from + along * limb.radius_to;
    });
  }
  /// The thickness is that of the steepest part; elsewhere the sheet is thicker.
  bool withinSheet(double middle, double thickness, double steepest) const {
    return std::abs(p.z() - middle) < 0.5 * thickness * std::hypot(1.0, steepest);
  }
};

inline bool contains(const Body& body, const Vec3& p_world) {
  return std::visit(Contains{body.world_from_body.inverse() * p_world}, body.solid);
}

/// Height of the lowest point: the support of the body downwards.
struct LowestPoint {
  const Eigen::Isometry3d& pose;
  double discBelow(double along, double radius) const {
    const double up = pose.linear()(2, 2);
    return pose.translation().z() + along * up - radius * std::sqrt(std::max(0.0, 1.0 - up * up));
  }
  double operator()(const Sheet& s) const { return (*this)(Box{s.half_x, s.half_y, 0.0}); }
  double operator()(const Box& b) const {
    return pose.translation().z() - std::abs(pose.linear()(2, 0)) * b.half_x -
           std::abs(pose.linear()(2, 1)) * b.half_y - std::abs(pose.linear()(2, 2)) * b.half_z;
  }
  double operator()(const Ball& b) const { return pose.translation().z() - b.radius; }
  double operator()(const Rod& r) const {
    return std::min(discBelow(-r.half_length, r.radius), discBelow(r.half_length, r.radius));
  }
  double operator()(const Frustum& f) const {
    const double slope = std::tan(f.half_angle);
    return std::min(discBelow(f.begin, f.begin * slope), discBelow(f.end, f.end * slope));
  }
  double operator()(const Cup& c) const { return (*this)(Rod{c.radius, c.half_length}); }
  double operator()(const Pot& p) const { return (*this)(Frustum{p.half_angle, p.begin, p.end}); }
  /// Of an upright one.
  double operator()(const Bowl& b) const { return pose.translation().z() + b.foot; }
  double operator()(const Ellipsoid& e) const {
    const Vec3 down = pose.linear().row(2);
    return pose.translation().z() - down.cwiseProduct(Vec3(e.half_x, e.half_y, e.half_z)).norm();
  }
  double operator()(const Torus& t) const { return discBelow(0.0, t.ring_radius) - t.tube_radius; }
  double operator()(const Lump& l) const {
    double depth = 0.0;
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 d = Vec3{random.gaussian(), random.gaussian(), random.gaussian()}.normalized();
      depth = std::max(depth, -(pose.linear() * d).z() * l.reach(d));
    }
    return pose.translation().z() - depth;
  }
  double operator()(const Limbs& limbs) const {
    double low = 1e9;
    for (const Limbs::Limb& limb : limbs.limbs) {
      low = std::min({low, (pose * limb.from).z() - limb.radius_from, (pose * limb.to).z() - limb.radius_to});
    }
    return low;
  }
  /// Of cloths and leaves by points inside.
  template <class Sheetlike>
  double operator()(const Sheetlike& sheet) const {
    double low = 1e9;
    for (int x = -100; x <= 100; ++x) {
      for (int y = -100; y <= 100; ++y) {
        const Vec3 p(0.01 * x * sheet.half_x, 0.01 * y * sheet.half_y, 0.0);
        const Vec3 middle(p.x(), p.y(), sheet.heightAt(p.x(), p.y()));
        if (Contains{middle}(sheet)) low = std::min(low, (pose * middle).z());
      }
    }
    return low;
  }
};

inline double lowestPoint(const Body& body) { return std::visit(LowestPoint{body.world_from_body}, body.solid); }

/// Random points just inside of a body (m, world), found by trying points of its bounding box.
inline std::vector<Vec3> pointsInside(const Body& body, int count, Random& random) {
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(body.corner_min[axis], body.corner_max[axis]);
    if (std::visit(Contains{p}, body.solid)) points.push_back(body.world_from_body * p);
  }
  return points;
}

inline Eigen::Isometry3d randomPose(const Vec3& position, Random& random) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position;
  Eigen::Quaterniond turn{random.gaussian(), random.gaussian(), random.gaussian(), random.gaussian()};
  pose.linear() = turn.normalized().toRotationMatrix();
  return pose;
}

}  // namespace primitect::synthetic
