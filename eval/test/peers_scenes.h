// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Clouds made by hand for the peers, as a sensor at the origin would see them along z.
#pragma once

#include <string>
#include <vector>

#include "eval/labelled_cloud.h"
#include "eval/methods.h"
#include "test/support/exact_shapes.h"

namespace primitect::test {

/// Noise of the scenes (m), along the normal.
constexpr double kNoise = 0.002;

/// RANSAC stops at the first model that explains the points within its threshold, 1 % of the diagonal (2.8 m) of these
/// scenes: errors up to that size are its nature.
constexpr double kRansacError = 0.028;

/// A wall at z = 2, 2 m x 2 m, 6000 points of it.
inline Plane wall() { return {{0.0, 0.0, 2.0}, {0.0, 0.0, -1.0}}; }

inline void add(std::vector<SurfacePoint>& points, const std::vector<SurfacePoint>& more) {
  points.insert(points.end(), more.begin(), more.end());
}

/// The wall and what stands in front of it, 2500 points.
inline eval::LabelledCloud inFrontOfWall(const std::vector<SurfacePoint>& object, Random& random) {
  std::vector<SurfacePoint> points = patchOf(wall(), 6000, 1.0, random);
  add(points, object);
  for (SurfacePoint& p : points) p.point += kNoise * random.gaussian() * p.normal;
  eval::LabelledCloud scene;
  scene.cloud = scene.scored = cloudOf(points);
  return scene;
}

inline eval::LabelledCloud wallAnd(const Sphere& sphere) {
  Random random(1);
  return inFrontOfWall(patchOf(sphere, 2500, random), random);
}

/// The part from `low` to `high` (m) along the axis.
template <class Round>
eval::LabelledCloud wallAnd(const Round& shape, double low, double high) {
  Random random(1);
  return inFrontOfWall(patchOf(shape, 2500, low, high, random), random);
}

template <class Kind>
std::vector<Kind> shapesOf(const eval::Answer& answer) {
  std::vector<Kind> shapes;
  for (const Shape& shape : answer.shapes) {
    if (const Kind* kind = std::get_if<Kind>(&shape)) shapes.push_back(*kind);
  }
  return shapes;
}

inline double degrees(double rad) { return rad * 180.0 / M_PI; }

/// Angle between two directions (deg).
inline double angleDeg(const Vec3& a, const Vec3& b) { return degrees(std::atan2(a.cross(b).norm(), a.dot(b))); }

}  // namespace primitect::test
