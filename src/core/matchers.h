// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Many points against one shape, in float: what they share is worked out once.
#pragma once

#include <cmath>

#include "primitect/primitives.h"

namespace primitect {

/// A sample against a shape.
struct Match {
  float distance;  ///< m
  float cosine;    ///< between its normal and the shape's outward one
};

struct FloatVector {
  float x, y, z;
};

inline FloatVector toFloat(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
inline float dot(const FloatVector& a, const FloatVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline FloatVector minus(const FloatVector& a, const FloatVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline FloatVector plus(const FloatVector& a, float factor, const FloatVector& b) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}
inline float length(const FloatVector& a) { return std::sqrt(dot(a, a)); }

struct PlaneMatcher {
  FloatVector point, normal;
  explicit PlaneMatcher(const Plane& plane) : point(toFloat(plane.point)), normal(toFloat(plane.normal)) {}
  float distanceTo(const FloatVector& p) const { return dot(normal, minus(p, point)); }
  Match operator()(const FloatVector& p, const FloatVector& n) const { return {distanceTo(p), dot(normal, n)}; }
};

struct SphereMatcher {
  FloatVector center;
  float radius;
  explicit SphereMatcher(const Sphere& sphere)
      : center(toFloat(sphere.center)), radius(static_cast<float>(sphere.radius)) {}
  float distanceTo(const FloatVector& p) const { return length(minus(p, center)) - radius; }
  Match operator()(const FloatVector& p, const FloatVector& n) const {
    const FloatVector out = minus(p, center);
    const float away = length(out);
    return {away - radius, dot(out, n) / away};
  }
};

struct CylinderMatcher {
  FloatVector point, axis;
  float radius;
  explicit CylinderMatcher(const Cylinder& cylinder)
      : point(toFloat(cylinder.point)), axis(toFloat(cylinder.axis)), radius(static_cast<float>(cylinder.radius)) {}
  float distanceTo(const FloatVector& p) const {
    const FloatVector offset = minus(p, point);
    return length(plus(offset, -dot(offset, axis), axis)) - radius;
  }
  Match operator()(const FloatVector& p, const FloatVector& n) const {
    const FloatVector offset = minus(p, point);
    const FloatVector out = plus(offset, -dot(offset, axis), axis);
    const float away = length(out);
    return {away - radius, dot(out, n) / away};
  }
};

struct ConeMatcher {
  FloatVector apex, axis;
  float sine, cosine;
  explicit ConeMatcher(const Cone& cone)
      : apex(toFloat(cone.apex)),
        axis(toFloat(cone.axis)),
        sine(static_cast<float>(std::sin(cone.half_angle))),
        cosine(static_cast<float>(std::cos(cone.half_angle))) {}
  float distanceTo(const FloatVector& p) const {
    const FloatVector offset = minus(p, apex);
    const float height = dot(offset, axis);
    const float away = length(plus(offset, -height, axis));
    // Behind the apex there is no surface.
    return height * cosine + away * sine > 0.0f ? away * cosine - height * sine : length(offset);
  }
  Match operator()(const FloatVector& p, const FloatVector& n) const {
    const FloatVector offset = minus(p, apex);
    const float height = dot(offset, axis);
    const FloatVector out = plus(offset, -height, axis);
    const float away = length(out);
    const float along = height * cosine + away * sine;
    // Behind the apex there is no surface.
    const float distance = along > 0.0f ? away * cosine - height * sine : length(offset);
    return {distance, cosine * dot(out, n) / away - sine * dot(axis, n)};
  }
};

inline PlaneMatcher matcherOf(const Plane& plane) { return PlaneMatcher(plane); }
inline SphereMatcher matcherOf(const Sphere& sphere) { return SphereMatcher(sphere); }
inline CylinderMatcher matcherOf(const Cylinder& cylinder) { return CylinderMatcher(cylinder); }
inline ConeMatcher matcherOf(const Cone& cone) { return ConeMatcher(cone); }

}  // namespace primitect
