// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The second-order bias of the normal equations, from two points either side of the surface; see bias.h.
#include "core/bias.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/flat_gradients.h"
#include "core/noise.h"

namespace primitect {
namespace {

/// The correction is a mean over so many points at most. Along rays it can be many times the random error, and its
/// tenth still is as much; otherwise more than these take 4 % of the instructions of the paper's scenes, and errors are
/// no smaller.
constexpr std::size_t kMostAlongAxes = 251, kMostAlongRays = 1021;
using BiasPoints = SomePoints<kMostAlongRays>;
constexpr std::size_t kRoom = BiasPoints::kRoom;

/// Sums over the points that took part in the fit.
struct BiasSums {
  Hessian information = Hessian::Zero();  ///< of g g' / sigma^2
  Gradient bias = Gradient::Zero();       ///< of E[r g] / sigma^2
  double measured = 0.0;                  ///< of (r / sigma)^2
  double expected = 0.0;                  ///< the same, as sigma has it
};

/// Offsets (m) of one standard deviation, and 1 / sigma for the points that took part, else 0.
struct Noise {
  float sigma[kRoom], weight[kRoom];
};

Noise noiseOf(const BiasPoints& points, const Feet<kRoom>& feet, const PointNoise& sigma) {
  Noise noise;
  sigma.at(points, noise.sigma);
  for (std::size_t k = 0; k < points.count; ++k) {
    const bool within = std::abs(feet.distance[k]) < static_cast<float>(kInlierDeviations) * noise.sigma[k];
    noise.weight[k] = within ? 1.0f / noise.sigma[k] : 0.0f;
  }
  return noise;
}

/// Adds half of r g / sigma^2 at the points moved so far (m) from the surface.
void addBias(const Shape& shape, const BiasPoints& points, const Noise& noise, float* const* place, BiasSums& sums) {
  // Not for what fills up: of these nothing is asked.
  const Feet<kRoom> feet(shape, points.origin, place[0], place[1], place[2], points.count);
  const FlatGradients<kRoom> gradients(shape, points.origin, place[0], place[1], place[2], feet, points.count);
  float weighted[kRoom];
  for (std::size_t k = 0; k < points.count; ++k) {
    weighted[k] = 0.5f * feet.distance[k] * noise.weight[k] * noise.weight[k];
  }
  for (int r = 0; r < gradients.rows; ++r) {
    sums.bias[r] += sumOfProducts(weighted, gradients.row[r], points.count);
  }
}

/// The mean of r g for noise that is symmetric around the surface: from a standard deviation above and below.
void addBothSides(const Shape& shape, const BiasPoints& points, const Feet<kRoom>& feet, const Noise& noise,
                  const float* const* direction, BiasSums& sums) {
  float x[kRoom], y[kRoom], z[kRoom];
  float* const place[] = {x, y, z};
  for (const float side : {1.0f, -1.0f}) {
    for (std::size_t k = 0; k < points.count; ++k) {
      const float step = side * noise.sigma[k];
      x[k] = points.x[k] - feet.distance[k] * feet.nx[k] + step * direction[0][k];
      y[k] = points.y[k] - feet.distance[k] * feet.ny[k] + step * direction[1][k];
      z[k] = points.z[k] - feet.distance[k] * feet.nz[k] + step * direction[2][k];
    }
    addBias(shape, points, noise, place, sums);
  }
}

/// Of a camera: along p / p.z.
void addAlongRays(const Shape& shape, const BiasPoints& points, const Feet<kRoom>& feet, const Noise& noise,
                  BiasSums& sums) {
  float x[kRoom], y[kRoom], z[kRoom];
  const Eigen::Vector3f origin = points.origin.cast<float>();
  for (std::size_t k = 0; k < points.count; ++k) {
    const float depth = origin.z() + points.z[k];
    x[k] = (origin.x() + points.x[k]) / depth, y[k] = (origin.y() + points.y[k]) / depth, z[k] = 1.0f;
    const float across = x[k] * feet.nx[k] + y[k] * feet.ny[k] + z[k] * feet.nz[k];
    if (noise.weight[k] > 0.0f) sums.expected += across * across;
  }
  const float* const ray[] = {x, y, z};
  addBothSides(shape, points, feet, noise, ray, sums);
}

void addAllAxes(const Shape& shape, const BiasPoints& points, const Feet<kRoom>& feet, const Noise& noise,
                BiasSums& sums) {
  float one[kRoom], none[kRoom];
  std::fill_n(one, points.count, 1.0f);
  std::fill_n(none, points.count, 0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    const float* const direction[] = {axis == 0 ? one : none, axis == 1 ? one : none, axis == 2 ? one : none};
    addBothSides(shape, points, feet, noise, direction, sums);
  }
  for (std::size_t k = 0; k < points.count; ++k) sums.expected += noise.weight[k] > 0.0f ? 1.0 : 0.0;
}

BiasSums sumsOf(const Shape& shape, const BiasPoints& points, const PointNoise& sigma, NoiseDirection direction) {
  const Feet<kRoom> feet(shape, points);
  const Noise noise = noiseOf(points, feet, sigma);
  const FlatGradients<kRoom> gradients(shape, points.origin, points.x, points.y, points.z, feet, points.count);
  BiasSums sums;
  sums.information = sumOfSquares(gradients, noise.weight, points.count);
  for (std::size_t k = 0; k < points.count; ++k) {
    const float share = feet.distance[k] * noise.weight[k];
    sums.measured += share * share;
  }
  direction == NoiseDirection::along_ray ? addAlongRays(shape, points, feet, noise, sums)
                                         : addAllAxes(shape, points, feet, noise, sums);
  return sums;
}

bool isSound(const Plane& plane) { return plane.point.allFinite() && plane.normal.allFinite(); }
bool isSound(const Sphere& sphere) { return sphere.center.allFinite() && sphere.radius > 0.0; }
bool isSound(const Cylinder& cylinder) { return cylinder.point.allFinite() && cylinder.radius > 0.0; }
bool isSound(const Cone& cone) {
  return cone.apex.allFinite() && 0.0 < cone.half_angle && cone.half_angle < M_PI / 2.0;
}

template <class T>
T corrected(const T& shape, BiasSums sums) {
  const double noise_sq = std::clamp(sums.measured / sums.expected, 0.0, 1.5);
  sums.information.diagonal().array() += 1e-9 * sums.information.trace() + 1e-12;
  const Gradient step = noise_sq * sums.information.ldlt().solve(sums.bias);
  const T result = stepped(shape, step);
  return step.allFinite() && isSound(result) ? result : shape;
}

}  // namespace

Shape withoutBias(const Shape& shape, const SeenPoints& inliers, const PointNoise& sigma, NoiseDirection direction) {
  const BiasPoints points(inliers, direction == NoiseDirection::along_ray ? kMostAlongRays : kMostAlongAxes);
  const BiasSums sums = sumsOf(shape, points, sigma, direction);
  return std::visit([&sums](const auto& s) -> Shape { return corrected(s, sums); }, shape);
}

}  // namespace primitect
