// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gradients of the distances of many points by a shape's local parameters (residuals.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/residuals.h"
#include "core/seen_points.h"

namespace primitect {

/// One row for each parameter that the kind has.
template <std::size_t room>
struct FlatGradients {
  int rows;
  float row[kMostParameters][room];

  /// Of points (m, from origin) whose feet are known.
  FlatGradients(const Shape& shape, const Vec3& origin, const float* x, const float* y, const float* z,
                const Feet<room>& feet, std::size_t count)
      : rows(parameterCount(kindOf(shape))) {
    std::visit([&](const auto& s) { fill(s, origin, x, y, z, feet, count); }, shape);
  }

 private:
  void dots(const Vec3& direction, const float* x, const float* y, const float* z, double offset, std::size_t count,
            float* result) {
    const Eigen::Vector3f d = direction.cast<float>();
    const float shift = static_cast<float>(offset);
    for (std::size_t i = 0; i < count; ++i) result[i] = d.x() * x[i] + d.y() * y[i] + d.z() * z[i] - shift;
  }

  void fill(const Plane& plane, const Vec3& origin, const float* x, const float* y, const float* z, const Feet<room>&,
            std::size_t count) {
    const Turn turn(plane.normal);
    const Vec3 place = plane.point - origin;
    dots(turn.first, x, y, z, turn.first.dot(place), count, row[0]);
    dots(turn.second, x, y, z, turn.second.dot(place), count, row[1]);
    std::fill_n(row[2], count, -1.0f);
  }

  void fill(const Sphere&, const Vec3&, const float*, const float*, const float*, const Feet<room>& feet,
            std::size_t count) {
    shifts(feet, count);
    std::fill_n(row[3], count, -1.0f);
  }

  void fill(const Cylinder& cylinder, const Vec3& origin, const float* x, const float* y, const float* z,
            const Feet<room>& feet, std::size_t count) {
    const Turn turn(cylinder.axis);
    dots(-turn.first, feet.nx, feet.ny, feet.nz, 0.0, count, row[0]);
    dots(-turn.second, feet.nx, feet.ny, feet.nz, 0.0, count, row[1]);
    dots(cylinder.axis, x, y, z, cylinder.axis.dot(cylinder.point - origin), count, row[4]);
    for (std::size_t i = 0; i < count; ++i) row[2][i] = row[4][i] * row[0][i], row[3][i] = row[4][i] * row[1][i];
    std::fill_n(row[4], count, -1.0f);
  }

  void fill(const Cone& cone, const Vec3& origin, const float* x, const float* y, const float* z,
            const Feet<room>& feet, std::size_t count) {
    const Turn turn(cone.axis);
    const auto cosine = static_cast<float>(std::cos(cone.half_angle)),
               tangent = std::tan(static_cast<float>(cone.half_angle));
    shifts(feet, count);
    dots(-turn.first / cosine, feet.nx, feet.ny, feet.nz, 0.0, count, row[3]);
    dots(-turn.second / cosine, feet.nx, feet.ny, feet.nz, 0.0, count, row[4]);
    dots(cone.axis, x, y, z, cone.axis.dot(cone.apex - origin), count, row[5]);
    for (std::size_t i = 0; i < count; ++i) {
      // Along the slant from the apex to the foot.
      const float slant = row[5][i] / cosine + tangent * feet.distance[i];
      row[3][i] *= slant, row[4][i] *= slant, row[5][i] = -slant;
    }
  }

  /// A shape that moves along its normal comes nearer.
  void shifts(const Feet<room>& feet, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      row[0][i] = -feet.nx[i], row[1][i] = -feet.ny[i], row[2][i] = -feet.nz[i];
    }
  }
};

/// In double: rounding must not make a matrix of such sums anything but one of squares.
template <class Value>
double sumOfProducts(const Value* a, const Value* b, std::size_t count) {
  constexpr std::size_t kSums = 4;
  double sums[kSums] = {};
  std::size_t i = 0;
  for (; i + kSums <= count; i += kSums) {
    for (std::size_t k = 0; k < kSums; ++k) sums[k] += static_cast<double>(a[i + k]) * static_cast<double>(b[i + k]);
  }
  for (; i < count; ++i) sums[0] += static_cast<double>(a[i]) * static_cast<double>(b[i]);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// Sum over points of g g', g = weight * gradient.
template <std::size_t room>
Hessian sumOfSquares(const FlatGradients<room>& gradients, const float* weight, std::size_t count) {
  double weighted[kMostParameters][room];
  for (int r = 0; r < gradients.rows; ++r) {
    for (std::size_t i = 0; i < count; ++i) weighted[r][i] = weight[i] * gradients.row[r][i];
  }
  Hessian sum = Hessian::Zero();
  for (int r = 0; r < gradients.rows; ++r) {
    for (int c = 0; c <= r; ++c) sum(r, c) = sum(c, r) = sumOfProducts(weighted[r], weighted[c], count);
  }
  return sum;
}

}  // namespace primitect
