// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the fits to image windows take and give; see loops.h.
#pragma once

#include <cstddef>

namespace primitect::kernels {

/// Points of an organized cloud; NaN where one is missing.
struct PointImage {
  const float *x, *y, *z;
  std::size_t width, height;
};

constexpr std::size_t kLargestHalfWidth = 30;  ///< px, of a window

/// A plane to be fitted to the window around a pixel. u = x / z, v = y / z, d = depth / z - 1.
struct WindowTask {
  std::size_t pixel;
  std::size_t half_width, inner_half_width;  ///< px; the inner window gives the start
  float depth, u, v;                         ///< of the centre (m, -, -)
  float largest_jump;                        ///< of d, that parts another surface, at the start
  float tolerance;                           ///< of d, about a plane that faces the camera
  float tolerance_per_slope;                 ///< of d, see toleranceOf()
  int fewest_at_start;                       ///< pixels
  float u_per_column, v_per_row;             ///< of a pinhole image; 0: not known, u and v are those of the points
};

/// d = a (u - u of the centre) + b (v - v of the centre) + c.
struct WindowPlane {
  double a = 0.0, b = 0.0, c = 0.0;
  double u = 0.0, v = 0.0;  ///< mean of its pixels, from the centre: x / z and y / z
  double variance = 0.0;    ///< of a and b (mean), for noise of d of 1
  int used = 0;             ///< pixels; 0: there is no such plane
};

/// What is tolerated of d about this plane. A camera errs sideways, too: the steeper a plane is seen, the more this is
/// of its depth. Up to a slope of 3, at 72 deg to the view in the image's middle, it is let be: windows beside the
/// limbs of cans are that steep, and bend. More than parts surfaces at the start is none of one surface.
static inline float toleranceOf(const WindowTask& task, const WindowPlane& plane) {
  constexpr double kGentle = 3.0;
  const double steeper = __builtin_sqrt(plane.a * plane.a + plane.b * plane.b) - kGentle;
  if (!(steeper > 0.0)) return task.tolerance;
  const double flat = static_cast<double>(task.tolerance), per_slope = static_cast<double>(task.tolerance_per_slope);
  const double wide = __builtin_sqrt(flat * flat + per_slope * per_slope * steeper * steeper);
  const double most = static_cast<double>(task.largest_jump);
  return static_cast<float>(wide < most ? wide : most);
}

}  // namespace primitect::kernels
