// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The normal at a pixel of a depth image, from the window around it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/image_rays.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

struct WindowNormal {
  Vec3 direction;
  Vec3 point;    ///< (m) steadied: on its ray, nearer to where the pixels around it see the surface
  Vec3 place;    ///< (m) amid the pixels, in the plane through that point: where a curved surface has this normal
  double sigma;  ///< rad, about each axis: what the depth noise of the model and the used pixels make of it
};

/// Normal at a pixel of an organized cloud, towards the sensor: robust plane fit of 1/z over x/z and y/z in a window of
/// (2 half_width + 1)^2 pixels, half_width at most kernels::kLargestHalfWidth. In these coordinates a plane is linear
/// and the noise of a depth camera even. Nothing when too few pixels of the window lie on one surface with the centre.
/// Needs z > 0. Takes half the time where the pitch is known. The noise is noise_scale times axialNoise().
std::optional<WindowNormal> windowNormal(const Cloud& cloud, std::uint32_t pixel, int half_width,
                                         const PixelPitch& pitch = {}, double noise_scale = 1.0);

/// The same at a point that falls into this pixel, whichever point the image holds there. steadying: how far the point
/// goes to where the pixels around it see the surface, from 0 (nowhere) to 1.
std::optional<WindowNormal> windowNormal(const Cloud& image, std::uint32_t pixel, const Vec3& center, int half_width,
                                         const PixelPitch& pitch = {}, double noise_scale = 1.0,
                                         double steadying = 0.0);

/// How depths stray from a smooth surface.
struct WindowNoise {
  double deviation;  ///< standard deviations of axialNoise(): up to about five; six at most
  /// Correlation of the errors of pixels two apart, in a row or a column; nothing where few tell it.
  std::optional<double> likeness;
};

/// Noise of the depths in such a window about the surface that leaves the plane as a parabola does. half_width as
/// above.
std::optional<WindowNoise> windowNoise(const Cloud& image, std::uint32_t pixel, int half_width,
                                       const PixelPitch& pitch);

}  // namespace primitect
