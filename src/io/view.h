// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From where a picture is seen: as the camera saw it, or orthographically.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "io/intrinsics.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::io {

/// Maps points (m) to pixels of a picture; the middle of the first pixel is (0, 0).
struct View {
  bool perspective = false;   ///< false: all lines of sight are parallel to forward
  int width = 0, height = 0;  ///< of the picture (px)
  Vec3 right = Vec3::UnitX(), down = Vec3::UnitY(), forward = Vec3::UnitZ();
  Intrinsics lens;  ///< orthographic: pixels per metre and the pixel of the origin

  /// Distance along forward (m).
  double depth(const Vec3& p) const { return forward.dot(p); }

  /// Nothing in front of the lens where the perspective ends (2 cm).
  std::optional<Eigen::Vector2d> project(const Vec3& p) const;

  /// Direction from the eye to p, any length.
  Vec3 lineOfSight(const Vec3& p) const { return perspective ? p : forward; }
};

/// The camera's own view of an image of that many pixels, `scale` times as large.
View cameraView(const Intrinsics& lens, std::uint32_t width, std::uint32_t height, int scale);

/// All of the cloud in a picture of that many pixels. A cloud in front of a camera at the origin is seen from there,
/// any other one across its two widest directions, from the side that its normals face, else from above (z up).
View orthographicView(const Cloud& cloud, int width, int height);

}  // namespace primitect::io
