// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The definition of the robust fit to an image window, pixel by pixel in double.
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "kernels/loops.h"
#include "primitect/primitives.h"

namespace primitect::test {

/// Least squares d = a u + b v + c over the pixels within `reach` that `counts(u, v, d)` accepts.
template <class Counts>
kernels::WindowPlane plainPass(const kernels::PointImage& image, const kernels::WindowTask& task, int reach,
                               const Counts& counts) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  kernels::WindowPlane plane;
  const int column = static_cast<int>(task.pixel % image.width), row = static_cast<int>(task.pixel / image.width);
  const int last_column = static_cast<int>(image.width) - 1, last_row = static_cast<int>(image.height) - 1;
  for (int r = std::max(row - reach, 0); r <= std::min(row + reach, last_row); ++r) {
    for (int c = std::max(column - reach, 0); c <= std::min(column + reach, last_column); ++c) {
      const std::size_t i = static_cast<std::size_t>(r) * image.width + c;
      const double inverse = 1.0 / image.z[i];
      const Vec3 ray(image.x[i] * inverse - task.u, image.y[i] * inverse - task.v, 1.0);
      const double d = task.depth * inverse - 1.0;
      if (!counts(ray.x(), ray.y(), d)) continue;
      moments += ray * ray.transpose();
      right += d * ray;
      ++plane.used;
    }
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(moments);
  if (plane.used < 3 || !(solver.vectorD().minCoeff() > 1e-9 * solver.vectorD().maxCoeff())) return {};
  const Vec3 found = solver.solve(right);
  const Eigen::Matrix3d spread = solver.solve(Eigen::Matrix3d::Identity());
  plane.a = found.x(), plane.b = found.y(), plane.c = found.z();
  plane.variance = 0.5 * (spread(0, 0) + spread(1, 1));
  return plane;
}

/// See kernels::Loops::fitWindow.
inline kernels::WindowPlane plainWindowFit(const kernels::PointImage& image, const kernels::WindowTask& task) {
  kernels::WindowPlane plane =
      plainPass(image, task, static_cast<int>(task.inner_half_width),
                [&](double, double, double d) { return std::abs(1.0 / (1.0 + d) - 1.0) < task.largest_jump; });
  if (plane.used < task.fewest_at_start || plane.used == 0) return {};
  const int reach = static_cast<int>(task.half_width);
  const auto refit = [&](double tolerance) {
    return plainPass(image, task, reach, [&](double u, double v, double d) {
      const double fitted = plane.a * u + plane.b * v + plane.c;
      return std::abs(1.0 / (1.0 + d) - 1.0 / (1.0 + fitted)) < tolerance;
    });
  };
  const int points = plainPass(image, task, reach, [](double, double, double d) { return d == d; }).used;
  plane = refit(task.tolerance);
  if (plane.used == 0 || plane.used > 0.9 * points) return plane;
  return refit(task.tolerance);
}

}  // namespace primitect::test
