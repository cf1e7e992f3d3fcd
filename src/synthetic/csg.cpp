// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Every face is sampled by its area; a sample stays when there is material on exactly one side of it.
#include "synthetic/csg.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "synthetic/poses.h"

namespace primitect::synthetic {
namespace {

constexpr double kStepAside = 1e-7;  // m, to either side of a face

/// Membership in a solid's own frame.
struct Contains {
  const Vec3& p;
  bool operator()(const Box& b) const {
    return std::abs(p.x()) < b.half_x && std::abs(p.y()) < b.half_y && std::abs(p.z()) < b.half_z;
  }
  bool operator()(const Ball& b) const { return p.squaredNorm() < b.radius * b.radius; }
  bool operator()(const Rod& r) const {
    return std::abs(p.z()) < r.half_length && p.head<2>().squaredNorm() < r.radius * r.radius;
  }
  bool operator()(const Frustum& f) const {
    return p.z() > f.begin && p.z() < f.end && p.head<2>().norm() < p.z() * std::tan(f.half_angle);
  }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }
};

bool isSupported(const Solid& solid) {
  return std::holds_alternative<Box>(solid) || std::holds_alternative<Ball>(solid) ||
         std::holds_alternative<Rod>(solid) || std::holds_alternative<Frustum>(solid);
}

/// Area (m^2) of a face, numbered as in world.h.
struct Area {
  int face;
  double operator()(const Box& b) const {
    const double sides[3] = {b.half_y * b.half_z, b.half_x * b.half_z, b.half_x * b.half_y};
    return 4.0 * sides[face / 2];
  }
  double operator()(const Ball& b) const { return 4.0 * kPi * b.radius * b.radius; }
  double operator()(const Rod& r) const {
    return face == 0 ? 4.0 * kPi * r.radius * r.half_length : kPi * r.radius * r.radius;
  }
  double operator()(const Frustum& f) const {
    const double slope = std::tan(f.half_angle);
    if (face == 0) return kPi * slope / std::cos(f.half_angle) * (f.end * f.end - f.begin * f.begin);
    const double radius = slope * (face == 1 ? f.end : f.begin);
    return kPi * radius * radius;
  }
  template <class Other>
  double operator()(const Other&) const {
    return 0.0;
  }
};

/// An evenly drawn point of a face, in the solid's own frame.
struct DrawPoint {
  int face;
  Random& random;

  Vec3 onCircle(double radius, double z) const {
    const double angle = random.uniform(0.0, 2.0 * kPi);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }
  Vec3 onDisc(double radius, double z) const { return onCircle(radius * std::sqrt(random.uniform()), z); }

  Vec3 operator()(const Box& b) const {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(-1.0, 1.0);
    p[face / 2] = face % 2 == 0 ? -1.0 : 1.0;
    return p.cwiseProduct(Vec3(b.half_x, b.half_y, b.half_z));
  }
  Vec3 operator()(const Ball& b) const {
    const double z = random.uniform(-1.0, 1.0);  // Archimedes: slices of the same height have the same area
    return b.radius * onCircle(std::sqrt(1.0 - z * z), z);
  }
  Vec3 operator()(const Rod& r) const {
    if (face != 0) return onDisc(r.radius, face == 1 ? -r.half_length : r.half_length);
    const double z = random.uniform(-r.half_length, r.half_length);
    return onCircle(r.radius, z);
  }
  Vec3 operator()(const Frustum& f) const {
    const double slope = std::tan(f.half_angle);
    if (face == 1) return onDisc(slope * f.end, f.end);
    if (face == 2) return onDisc(slope * f.begin, f.begin);
    const double z = std::sqrt(random.uniform(f.begin * f.begin, f.end * f.end));
    return onCircle(slope * z, z);
  }
  template <class Other>
  Vec3 operator()(const Other&) const {
    return Vec3::Zero();
  }
};

}  // namespace

void Csg::add(const Placed& placed, const Eigen::Isometry3d& frame) { append(placed, frame, false); }
void Csg::cut(const Placed& placed, const Eigen::Isometry3d& frame) { append(placed, frame, true); }

void Csg::append(const Placed& placed, const Eigen::Isometry3d& frame, bool cuts) {
  if (!isSupported(placed.solid)) throw std::invalid_argument("csg: a solid must be a box, ball, rod or frustum");
  const Eigen::Isometry3d pose = frame * placed.pose;
  World world;
  world.add("step", placed.solid, pose);
  const int step = static_cast<int>(steps_.size());
  steps_.push_back({placed.solid, pose, pose.inverse(), cuts, static_cast<int>(surfaces_.size())});
  for (Surface surface : world.surfaces()) {
    surface.body = step;
    surface.concave = cuts && kindOf(surface.shape) != Kind::plane;
    if (Plane* plane = std::get_if<Plane>(&surface.shape); plane && cuts) plane->normal = -plane->normal;
    surfaces_.push_back(surface);
  }
}

bool Csg::inside(const Vec3& p) const {
  // The last step that has the point decides.
  for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
    const Vec3 p_body = step->body_from_world * p;
    if (std::visit(Contains{p_body}, step->solid)) return !step->cuts;
  }
  return false;
}

bool Csg::isVisible(const BoundaryPoint& sample, std::size_t step) const {
  const Vec3 outer = sample.point + kStepAside * sample.normal, inner = sample.point - kStepAside * sample.normal;
  if (inside(outer) || !inside(inner)) return false;
  // An earlier step with a face right here: the sample would be counted twice.
  return std::none_of(steps_.begin(), steps_.begin() + step, [&](const Step& earlier) {
    const Vec3 outer_body = earlier.body_from_world * outer, inner_body = earlier.body_from_world * inner;
    return std::visit(Contains{outer_body}, earlier.solid) != std::visit(Contains{inner_body}, earlier.solid);
  });
}

std::vector<BoundaryPoint> Csg::sampleBoundary(std::size_t count, Random& random) const {
  std::vector<double> area_until;
  double area = 0.0;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const Step& step = steps_[surfaces_[i].body];
    area += std::visit(Area{static_cast<int>(i) - step.first_surface}, step.solid);
    area_until.push_back(area);
  }
  std::vector<BoundaryPoint> samples;
  for (std::size_t draws = 0; samples.size() < count; ++draws) {
    if (area <= 0.0 || draws > 1000 * (count + 1)) throw std::runtime_error("csg: no boundary is left to sample");
    const double at = random.uniform(0.0, area);
    const int surface =
        static_cast<int>(std::upper_bound(area_until.begin(), area_until.end(), at) - area_until.begin());
    const Step& step = steps_[surfaces_[surface].body];
    const DrawPoint draw{surface - step.first_surface, random};
    const Vec3 point = step.world_from_body * std::visit(draw, step.solid);
    const Vec3 normal = normalAt(surfaces_[surface].shape, point);
    const BoundaryPoint sample{point, surfaces_[surface].concave ? Vec3(-normal) : normal, surface};
    if (isVisible(sample, surfaces_[surface].body)) samples.push_back(sample);
  }
  return samples;
}

}  // namespace primitect::synthetic
