// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The pinhole camera of the simulated sensor.
#pragma once

#include <Eigen/Core>
#include <limits>

namespace primitect::synthetic {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();  ///< the depth of a pixel that saw nothing

/// Pinhole without distortion, in pixels; integer coordinates are pixel centres. Optical frame: x right, y down, z
/// forward. The defaults are those of a Kinect-class sensor.
struct PinholeCamera {
  int width = 640;
  int height = 480;
  double fx = 570.3;
  double fy = 570.3;
  double cx = 319.5;
  double cy = 239.5;

  /// Direction through pixel (u, v) with z = 1: multiplied by a depth it is the point (m).
  Eigen::Vector3d ray(double u, double v) const { return {(u - cx) / fx, (v - cy) / fy, 1.0}; }

  /// Pixel of a point (m) with z > 0.
  Eigen::Vector2d project(const Eigen::Vector3d& p) const { return {fx * p.x() / p.z() + cx, fy * p.y() / p.z() + cy}; }

  /// The same view in another resolution: the horizontal field of view stays, pixels stay square.
  PinholeCamera scaledTo(int new_width, int new_height) const {
    const double scale = static_cast<double>(new_width) / width;
    return {new_width, new_height, fx * scale, fy * scale, 0.5 * (new_width - 1), 0.5 * (new_height - 1)};
  }

  std::size_t pixelCount() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

}  // namespace primitect::synthetic
