// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points and normals that lie exactly on a shape, in random poses: the truth that tests compare with.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "core/degree.h"
#include "core/pair_voting.h"
#include "core/random.h"
#include "core/samples.h"
#include "kernels/kernels.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::test {

using primitect::kDegree;

constexpr std::array<Kind, kKindCount> kKinds = {Kind::plane, Kind::sphere, Kind::cylinder, Kind::cone};

struct SurfacePoint {
  Vec3 point, normal;
};

inline Vec3 randomDirection(Random& random) {
  return Vec3{random.gaussian(), random.gaussian(), random.gaussian()}.normalized();
}

/// Less than a right angle from the view: a cone opens away from the sensor and shows its outside.
inline Vec3 randomDirectionAway(Random& random) {
  const Vec3 direction = randomDirection(random);
  return direction.z() < 0.0 ? Vec3(-direction) : direction;
}

inline Vec3 randomPoint(Random& random, double reach = 1.0) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

inline Vec3 aroundAxis(const Vec3& axis, double angle) {
  const Vec3 x = axis.unitOrthogonal();
  return std::cos(angle) * x + std::sin(angle) * axis.cross(x);
}

inline SurfacePoint pointOn(const Plane& plane, double u, double v) {
  const Vec3 x = plane.normal.unitOrthogonal();
  return {plane.point + u * x + v * plane.normal.cross(x), plane.normal};
}
inline SurfacePoint pointOn(const Sphere& sphere, const Vec3& direction) {
  return {sphere.center + sphere.radius * direction, direction};
}
inline SurfacePoint pointOn(const Cylinder& cylinder, double height, double angle) {
  const Vec3 out = aroundAxis(cylinder.axis, angle);
  return {cylinder.point + height * cylinder.axis + cylinder.radius * out, out};
}
inline SurfacePoint pointOn(const Cone& cone, double height, double angle) {
  const Vec3 out = aroundAxis(cone.axis, angle);
  return {cone.apex + height * (cone.axis + std::tan(cone.half_angle) * out),
          std::cos(cone.half_angle) * out - std::sin(cone.half_angle) * cone.axis};
}

/// Where pointOn() is to be: height and angle, or u and v. Between braces they may be drawn, in this order.
struct Coordinates {
  double first, second;
};

template <class Surface>
SurfacePoint pointOn(const Surface& surface, const Coordinates& at) {
  return pointOn(surface, at.first, at.second);
}

inline kernels::OrientedPoint toKernel(const SurfacePoint& p) {
  const auto convert = [](const Vec3& v) {
    return kernels::Vector{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
  };
  return {convert(p.point), convert(p.normal)};
}

inline void append(Samples& samples, const SurfacePoint& p) {
  const kernels::OrientedPoint o = toKernel(p);
  samples.x.push_back(o.point.x);
  samples.y.push_back(o.point.y);
  samples.z.push_back(o.point.z);
  samples.px.push_back(o.point.x);
  samples.py.push_back(o.point.y);
  samples.pz.push_back(o.point.z);
  samples.nx.push_back(o.normal.x);
  samples.ny.push_back(o.normal.y);
  samples.nz.push_back(o.normal.z);
  for (List<float>* noise : {&samples.normal_sigma, &samples.sigma, &samples.inverse_tolerance, &samples.normal_loss,
                             &samples.farthest_turn})
    noise->push_back(0.0f);
  samples.index.push_back(static_cast<std::uint32_t>(samples.index.size()));
}

inline Samples samplesOf(const std::vector<SurfacePoint>& points) {
  Samples samples;
  for (const SurfacePoint& p : points) append(samples, p);
  return samples;
}

inline List<std::uint32_t> allOf(const Samples& samples) {
  List<std::uint32_t> indices(samples.size());
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

/// Points with their normals, unorganized; NaN makes a missing point.
inline Cloud cloudOf(const std::vector<SurfacePoint>& points) {
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(points.size()), 1, true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i].point;
    const Vec3& n = points[i].normal;
    cloud.setPoint(i, static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), {});
    cloud.setNormal(i, static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()));
  }
  return cloud;
}

/// Points without normals, unorganized.
inline Cloud listOf(const std::vector<Vec3>& points) {
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(points.size()), 1, false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = points[i].cast<float>();
    cloud.setPoint(i, p.x(), p.y(), p.z(), {});
  }
  return cloud;
}

/// An organized cloud of a pinhole camera (160 x 120, focal length 140 px) that looks at one plane n.p = offset.
inline Cloud cameraCloud(const Vec3& normal, double offset) {
  Cloud cloud;
  cloud.reset(160, 120, false);
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const Vec3 ray((column - 79.5) / 140.0, (row - 59.5) / 140.0, 1.0);
      const Vec3 p = ray * (offset / normal.dot(ray));
      cloud.setPoint(row * 160 + column, static_cast<float>(p.x()), static_cast<float>(p.y()),
                     static_cast<float>(p.z()), {});
    }
  }
  return cloud;
}

/// Points of several clouds, one after the other.
inline std::vector<SurfacePoint> together(std::initializer_list<std::vector<SurfacePoint>> clouds) {
  std::vector<SurfacePoint> points;
  for (const std::vector<SurfacePoint>& cloud : clouds) points.insert(points.end(), cloud.begin(), cloud.end());
  return points;
}

/// Angle between two lines (rad), signs ignored.
inline double lineAngle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }

/// Angle between two directions (rad).
inline double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Random patches: points of one side, as a camera would see them.
inline std::vector<SurfacePoint> patchOf(const Plane& plane, int count, double reach, Random& random) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(pointOn(plane, {random.uniform(-reach, reach), random.uniform(-reach, reach)}));
  }
  return points;
}
inline std::vector<SurfacePoint> patchOf(const Sphere& sphere, int count, Random& random) {
  std::vector<SurfacePoint> points;
  const Vec3 towards = -sphere.center.normalized();
  while (static_cast<int>(points.size()) < count) {
    const Vec3 direction = randomDirection(random);
    if (direction.dot(towards) > 0.1) points.push_back(pointOn(sphere, direction));
  }
  return points;
}
/// So many points of cylinder or cone, between these heights, that wanted() takes; throws where it hardly takes any.
template <class Round, class Wanted>
std::vector<SurfacePoint> somePointsOf(const Round& shape, int count, double low, double high, Random& random,
                                       const Wanted& wanted) {
  constexpr int kMostDraws = 1000;  // for each of them
  std::vector<SurfacePoint> points;
  for (int draw = 0; static_cast<int>(points.size()) < count; ++draw) {
    if (draw == kMostDraws * count) throw std::logic_error("a shape that shows the sensor nothing of that side");
    const SurfacePoint p = pointOn(shape, {random.uniform(low, high), random.uniform(0.0, 2.0 * M_PI)});
    if (wanted(p)) points.push_back(p);
  }
  return points;
}
template <class Round>
std::vector<SurfacePoint> patchOf(const Round& shape, int count, double low, double high, Random& random) {
  return somePointsOf(shape, count, low, high, random,
                      [](const SurfacePoint& p) { return p.normal.dot(p.point) < 0.0; });
}

/// What a sensor at the origin sees of the far side, from inside.
inline std::vector<SurfacePoint> bowlOf(const Sphere& sphere, int count, Random& random) {
  std::vector<SurfacePoint> points;
  while (static_cast<int>(points.size()) < count) {
    const SurfacePoint p = pointOn(sphere, randomDirection(random));
    if (p.normal.dot(p.point) > 0.0) points.push_back({p.point, -p.normal});
  }
  return points;
}
template <class Round>
std::vector<SurfacePoint> wallOf(const Round& shape, int count, double low, double high, Random& random) {
  std::vector<SurfacePoint> points =
      somePointsOf(shape, count, low, high, random, [](const SurfacePoint& p) { return p.normal.dot(p.point) > 0.0; });
  for (SurfacePoint& p : points) p.normal = -p.normal;
  return points;
}

}  // namespace primitect::test
