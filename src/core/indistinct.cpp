// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Thin tubes, planes seen edge-on, bands of balls; see indistinct.h.
#include "core/indistinct.h"

#include <cmath>
#include <optional>

#include "core/ball_band.h"

namespace primitect {
namespace {

/// Of a tube, of a cone about this place; nothing of other kinds.
std::optional<double> radiusAbout(const Vec3& place, const Shape& shape) {
  if (const Cone* cone = std::get_if<Cone>(&shape)) {
    return std::abs((place - cone->apex).dot(cone->axis)) * std::tan(cone->half_angle);
  }
  const Cylinder* tube = std::get_if<Cylinder>(&shape);
  return tube ? std::optional<double>(tube->radius) : std::nullopt;
}

bool isThin(const Shape& shape, const FittedSamples& samples) {
  constexpr double kLeastRadius = 6.5;  // standard deviations of the noise
  // Cones are wider than that at one end. With none as least, the recorded calibration board, where nothing is curved,
  // carries thin sharp cones once mirrored, scaled or with noise added; with 6.5 more of those that are there are lost.
  constexpr double kLeastOfCones = 5.0;
  constexpr double kOfEdge = 0.8;  // length of the mean normal: over a right angle .9, over half a turn .64
  const bool edge = samples.fitted_normals && samples.moments.mean_normal.norm() > kOfEdge;
  if (!samples.noise.ofDepthCamera() && !edge) return false;
  const std::optional<double> radius = radiusAbout(samples.moments.mean_point, shape);
  const double least = kindOf(shape) == Kind::cone ? kLeastOfCones : kLeastRadius;
  return radius && *radius < least * samples.sigma;
}

bool isEdgeOn(const Shape& shape, const FittedSamples& samples) {
  constexpr double kLeastSine = 0.02;  // of the angle between the plane and the way to it: 1.1 deg
  const Plane* plane = std::get_if<Plane>(&shape);
  const Vec3& seen = samples.moments.mean_point;
  return samples.noise.ofDepthCamera() && plane && std::abs(plane->normal.dot(seen)) < kLeastSine * seen.norm();
}

}  // namespace

std::optional<Refusal> whyIndistinct(const Shape& shape, const FittedSamples& samples) {
  if (isThin(shape, samples)) return Refusal::too_small;
  return isEdgeOn(shape, samples) ? std::optional<Refusal>(Refusal::edge_on) : std::nullopt;
}

bool mayBeRing(const Shape& shape, const FittedSamples& samples) {
  constexpr double kElongation = 4.0;  // from 3 on a recorded bowl under a can goes missing
  constexpr double kLeastRise = 1.2;   // standard deviations of the noise
  const Sphere* ball = std::get_if<Sphere>(&shape);
  if (!ball || !samples.noise.ofDepthCamera()) return false;
  const BallBand band = bandOn(*ball, samples.moments.mean_point, samples.moments.points);
  return band.elongation > kElongation && band.rise < kLeastRise * samples.sigma;
}

}  // namespace primitect
