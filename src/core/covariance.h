// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How far a fitted shape may be off: the covariance of its parameters and of its published pose.
#pragma once

#include <array>
#include <limits>

#include "core/depth_waves.h"
#include "core/point_noise.h"
#include "core/residuals.h"
#include "core/seen_points.h"
#include "core/shared_noise.h"
#include "primitect/primitives.h"

namespace primitect {

/// Variance (m^2, rad^2) of what cannot be observed, and the largest that is reported.
constexpr double kUnobservable = 1e6;

struct Uncertainty {
  /// Covariance of the pose, 6 x 6 row-major, x y z rotX rotY rotZ (m, rad): shift of the extent's origin and turn,
  /// both about the fixed axes of the cloud's frame.
  std::array<double, 36> pose;
  double radius_stddev = 0.0;      ///< m; sphere, cylinder; cone: at the wide end of the observed part; plane: 0
  double half_angle_stddev = 0.0;  ///< rad; cone; others: 0
  /// Of the origin and of the z axis, along the worst of the directions in which they can be observed (m, rad); sphere:
  /// its axis is none, 0.
  double position_stddev = 0.0, axis_stddev = 0.0;
};

/// What several points have of their errors together.
struct SharedErrors {
  SharedNoise noise;  ///< of neighbours
  DepthWaves waves;   ///< of the depth; points are then in the camera's frame
};

/// Covariance of the local parameters (residuals.h; m, rad) of a shape that refine() has fitted to these points with
/// the tolerance kInlierDeviations * sigma(p). Unused parameters have variance 0, those that the points do not
/// determine at most kUnobservable. The scale of the noise is taken from the residuals: sigma(p) (m) need only tell how
/// the points compare. Points beyond the tolerance do not count.
Hessian measureCovariance(const Shape& shape, const SeenPoints& inliers, const PointNoise& sigma,
                          const SharedErrors& shared = {});

/// Rad, finite where the fit held the axis of a cylinder or a cone: by how much that is off, by the noise that is
/// shown, and by all.
struct HeldAxis {
  double by_noise = std::numeric_limits<double>::infinity();
  double by_all = by_noise;
};

/// Of one fit, twice.
struct Uncertainties {
  /// By the noise that is shown (SharedNoise): what decides whether a shape is believed. Limits are fitted to it. By
  /// all of what points share 334 instead of 345 of 348 shapes were found on tables with grains of 7 pixels, and 6
  /// instead of 10 false ones (compare --set tabletop --seeds 300:40 --noise-grain 7).
  Uncertainty by_noise;
  Uncertainty by_all;  ///< what is published
};

/// Of pose and size, as they are published. Unobservable, hence kUnobservable: plane: shifts within it and the turn
/// about its normal; sphere: turns; cylinder: shift along and turn about its axis; cone: turn about its axis. The
/// origin of a cone is taken as fixed to it, at its height above the apex: along the axis it is as uncertain as the
/// apex. The radius of a cone is that where its wide end was seen.
Uncertainties measureUncertainty(const Shape& shape, const Extent& extent, const SeenPoints& inliers,
                                 const PointNoise& sigma, const SharedErrors& shared = {}, const HeldAxis& axis = {});

}  // namespace primitect
