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
  plane.u = moments(0, 2) / plane.used, plane.v = moments(1, 2) / plane.used;
  plane.variance = 0.5 * (spread(0, 0) + spread(1, 1));
  return plane;
}

/// What is tolerated about a plane; steep: above a slope of 3.
inline double plainTolerance(const kernels::WindowTask& task, const kernels::WindowPlane& plane) {
  const double steeper = std::max(std::hypot(plane.a, plane.b) - 3.0, 0.0);
  if (steeper == 0.0) return task.tolerance;
  return std::min<double>(std::hypot(task.tolerance, task.tolerance_per_slope * steeper), task.largest_jump);
}

/// Sum of d minus the plane's, squared, over all pixels of the window; NaN where one is missing.
inline double leftOver(const kernels::PointImage& image, const kernels::WindowTask& task,
                       const kernels::WindowPlane& plane) {
  double squares = 0.0;
  plainPass(image, task, static_cast<int>(task.half_width), [&](double u, double v, double d) {
    squares += std::pow(d - plane.a * u - plane.b * v - plane.c, 2);
    return true;
  });
  return squares;
}

/// See kernels::Loops::fitWindow.
inline kernels::WindowPlane plainWindowFit(const kernels::PointImage& image, const kernels::WindowTask& task) {
  const int reach = static_cast<int>(task.half_width);
  const auto measured = [](double, double, double d) { return d == d; };
  if (task.u_per_column != 0.0f) {
    const kernels::WindowPlane plane = plainPass(image, task, reach, measured);
    if (leftOver(image, task, plane) < plane.used * std::pow(0.42 * task.tolerance, 2)) return plane;
  }
  const auto near = [&](double, double, double d) { return std::abs(d) < task.largest_jump; };
  const kernels::WindowPlane start = plainPass(image, task, static_cast<int>(task.inner_half_width), near);
  if (start.used < task.fewest_at_start || start.used == 0) return {};
  const auto refit = [&](const kernels::WindowPlane& plane) {
    const double tolerance = plainTolerance(task, plane);
    return plainPass(image, task, reach, [&](double u, double v, double d) {
      return std::abs(d - (plane.a * u + plane.b * v + plane.c)) < tolerance;
    });
  };
  const kernels::WindowPlane plane = refit(start);
  if (plane.used == 0) return plane;
  const double slope_sq = std::pow(plane.a - start.a, 2) + std::pow(plane.b - start.b, 2);
  const double shift_sq = slope_sq / (plane.used * plane.variance) + std::pow(plane.c - start.c, 2);
  return shift_sq < std::pow(0.1 * plainTolerance(task, start), 2) ? plane : refit(plane);
}

}  // namespace primitect::test
