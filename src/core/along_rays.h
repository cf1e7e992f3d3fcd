// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points of a depth camera for least squares without bias: the depth is wrong, the pixel is not.
#pragma once

#include "core/fit_points.h"
#include "core/seen_points.h"

namespace primitect {

/// A measured point p is where its ray meets the surface, q, and an error of the depth. Its distance from the surface
/// is of second order off from what that error makes across the surface, (p - q).n, and the foot of p is beside q by as
/// much as the error is: gradients there go with the noise. So a cone of which a small patch is seen opens by several
/// of its standard deviations. The point q + ((p - q).n) n has q as its foot, and that distance.
class AlongRays {
 public:
  explicit AlongRays(const FitPoints& points) : points_(points), x_(points.view().count), y_(x_), z_(x_) {}

  /// The points for a step from this shape, valid until the next call. Those whose rays nearly touch the surface stay
  /// where they are.
  kernels::FitPoints pointsFor(const Shape& shape);

  /// The same, for measures of the fit.
  SeenPoints seenFor(const Shape& shape);

 private:
  const FitPoints& points_;
  List<float> x_, y_, z_;
};

}  // namespace primitect
