// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From a pixel along the slope, to both sides; see flying_pixels.h.
#include "core/flying_pixels.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"

namespace primitect {
namespace {

/// The plane through a point of an image.
class Slope {
 public:
  Slope(const Cloud& image, const ImageRays& rays, std::uint32_t pixel, const Vec3& normal)
      : image_(image),
        rays_(rays),
        normal_(normal),
        depth_(image.z[pixel]),
        offset_(normal.dot(image.point(pixel))),
        column_(pixel % image.width),
        row_(pixel / image.width) {
    // Where depth grows fastest, px.
    const double right = normal.x() * rays.x_scale, down = normal.y() * rays.y_scale, length = std::hypot(right, down);
    right_ = right / length, down_ = down / length;
  }

  /// How many pixels the image stays on the plane, to the side of growing depth (1) or to the other (-1); most at most,
  /// and as many where the image ends.
  int stepsOn(double side, int most) const {
    double before = depth_;
    for (int k = 1; k <= most; ++k) {
      const auto column = static_cast<int>(std::lround(column_ + side * k * right_));
      const auto row = static_cast<int>(std::lround(row_ + side * k * down_));
      if (!isInside(column, row)) return most;
      const double expected = offset_ / normal_.dot(rays_.through(column, row));
      if (!isOn(column, row, expected, std::abs(expected - before))) return k - 1;
      before = expected;
    }
    return most;
  }

 private:
  bool isInside(int column, int row) const {
    return 0 <= column && column < static_cast<int>(image_.width) && 0 <= row && row < static_cast<int>(image_.height);
  }

  /// step: m, by which the depth changes from pixel to pixel
  bool isOn(int column, int row, double expected, double step) const {
    constexpr double kOfStep = 0.5, kDeviations = 2.0;
    const double measured = image_.z[static_cast<std::size_t>(row) * image_.width + static_cast<std::size_t>(column)];
    return std::abs(measured - expected) < kOfStep * step + kDeviations * axialNoise(depth_);
  }

  const Cloud& image_;
  const ImageRays& rays_;
  const Vec3 normal_;
  const double depth_, offset_, column_, row_;
  double right_, down_;
};

}  // namespace

bool fliesBetween(const Cloud& image, const ImageRays& rays, std::uint32_t pixel, const Vec3& normal, double share) {
  // Of curved surfaces near their limb, with .25, small ones are lost.
  constexpr double kSteepest = 0.2;  // sine of the angle to the surface
  constexpr double kWidest = 7.0;    // px, of usual images
  if (!rays.known) return false;
  const Vec3 point = image.point(pixel);
  if (!(std::abs(normal.dot(point)) < kSteepest * point.norm())) return false;
  const int widest = std::max(1, static_cast<int>(std::lround(kWidest * share)));
  const Slope slope(image, rays, pixel, normal);
  const int behind = slope.stepsOn(1.0, widest);
  return behind + 1 + slope.stepsOn(-1.0, widest - behind) <= widest;
}

}  // namespace primitect
