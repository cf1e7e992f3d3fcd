// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Noisy patches as a sensor sees them, and how far a fit to them is from the truth, in the fit's own parameters.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "core/bias.h"
#include "core/covariance.h"
#include "core/fitting.h"
#include "test/support/exact_shapes.h"
#include "test/support/linear_algebra.h"

namespace primitect::test {

/// Step from a fit to the truth: stepped(fit, error) is the true surface.
inline Gradient errorOf(const Plane& fit, const Plane& truth) {
  const Turn turn(fit.normal);
  const double cosine = truth.normal.dot(fit.normal);
  Gradient error = Gradient::Zero();
  error.head<3>() << truth.normal.dot(turn.first), truth.normal.dot(turn.second),
      (truth.point - fit.point).dot(truth.normal);
  return error / cosine;
}
inline Gradient errorOf(const Sphere& fit, const Sphere& truth) {
  Gradient error = Gradient::Zero();
  error.head<4>() << truth.center - fit.center, truth.radius - fit.radius;
  return error;
}
inline Gradient errorOf(const Cylinder& fit, const Cylinder& truth) {
  const Turn turn(fit.axis);
  const double cosine = truth.axis.dot(fit.axis);
  const Vec3 offset = truth.point - fit.point;
  const Vec3 across = offset - offset.dot(fit.axis) / cosine * truth.axis;
  Gradient error = Gradient::Zero();
  error.head<5>() << across.dot(turn.first), across.dot(turn.second), truth.axis.dot(turn.first) / cosine,
      truth.axis.dot(turn.second) / cosine, truth.radius - fit.radius;
  return error;
}
inline Gradient errorOf(const Cone& fit, const Cone& truth) {
  const Turn turn(fit.axis);
  const double cosine = truth.axis.dot(fit.axis);
  Gradient error;
  error << truth.apex - fit.apex, truth.axis.dot(turn.first) / cosine, truth.axis.dot(turn.second) / cosine,
      truth.half_angle - fit.half_angle;
  return error;
}
/// Of two shapes of the same kind.
inline Gradient errorOf(const Shape& fit, const Shape& truth) {
  return std::visit([&truth](const auto& s) { return errorOf(s, std::get<std::decay_t<decltype(s)>>(truth)); }, fit);
}

/// Normalised squared error over the number of parameters: 1 in the mean when the covariance is right.
inline double normalisedError(const Shape& fit, const Shape& truth, const Hessian& covariance) {
  const int count = parameterCount(kindOf(fit));
  return normalisedSquare(errorOf(fit, truth).head(count), covariance.topLeftCorner(count, count)) / count;
}

struct Patch {
  Shape truth;
  std::vector<SurfacePoint> points;
};

/// A random shape of 4 to 20 cm (cones of 12 to 50 deg) about 1 m from the sensor at the origin, and `count` exact
/// points of the side that the sensor sees.
inline Patch randomPatch(Kind kind, int count, Random& random) {
  const Vec3 place = Vec3(0, 0, 1) + 0.2 * randomPoint(random);
  Vec3 axis = randomDirection(random);
  if (kind == Kind::plane) {
    // Seen at least 10 deg from edge-on.
    while (std::abs(axis.dot(place.normalized())) < 0.17) axis = randomDirection(random);
    const Plane plane = {place, axis.dot(place) > 0.0 ? Vec3(-axis) : axis};
    return {plane, patchOf(plane, count, random.uniform(0.05, 0.2), random)};
  }
  if (kind == Kind::sphere) {
    const Sphere sphere = {place, random.uniform(0.04, 0.2)};
    return {sphere, patchOf(sphere, count, random)};
  }
  // Not along the view: there a cylinder shows nothing but its end, a cone towards the sensor its base.
  while (std::abs(axis.dot(place.normalized())) > 0.9) axis = randomDirection(random);
  if (kind == Kind::cylinder) {
    const Cylinder cylinder = {place, axis, random.uniform(0.04, 0.2)};
    return {cylinder, patchOf(cylinder, count, -0.1, 0.1, random)};
  }
  const Cone cone = {place, axis.dot(place) < 0.0 ? Vec3(-axis) : axis, random.uniform(12.0, 50.0) * M_PI / 180.0};
  return {cone, patchOf(cone, count, 0.05, 0.25, random)};
}

using Noise = std::function<double(const Vec3&)>;  ///< m, one standard deviation at a point

/// The robust fit to all of the points, from the given start.
inline std::optional<Shape> fitTo(const std::vector<SurfacePoint>& points, const Shape& start, const Noise& noise) {
  const Samples samples = samplesOf(points);
  const List<std::uint32_t> all = allOf(samples);
  return refine(start, {samples, all}, [&noise](const Vec3& p) { return kInlierDeviations * noise(p); });
}

/// A patch measured with noise of sigma (m), and what is fitted to it from the truth as start.
struct NoisyFit {
  std::vector<Vec3> measured;
  std::optional<Shape> shape;
  double sigma;
  NoiseDirection direction;

  NoisyFit(const Patch& patch, double noise_sigma, NoiseDirection noise_direction, Random& random)
      : sigma(noise_sigma), direction(noise_direction) {
    std::vector<SurfacePoint> points = patch.points;
    for (SurfacePoint& p : points) {
      p.point += direction == NoiseDirection::any
                     ? Vec3(sigma * Vec3{random.gaussian(), random.gaussian(), random.gaussian()})
                     : Vec3(sigma * random.gaussian() * p.point / p.point.z());
      measured.push_back(p.point);
    }
    shape = fitTo(points, patch.truth, noise());
  }

  Noise noise(double scale = 1.0) const {
    return [value = scale * sigma](const Vec3&) { return value; };
  }
  /// The shape with its bias taken out, as it is when the noise is said to be so many times what it is.
  Shape unbiased(double scale = 1.0) const { return withoutBias(*shape, measured, noise(scale), direction); }
};

}  // namespace primitect::test
