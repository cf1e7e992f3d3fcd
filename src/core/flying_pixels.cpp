// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From a pixel along the slope, to both sides; see flying_pixels.h.
#include "core/flying_pixels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/noise.h"

namespace primitect {
namespace {

/// The plane through a point of an image.
class Slope {
 public:
  Slope(const ImageOfCamera& camera, std::uint32_t pixel, const Vec3& point, const Vec3& normal)
      : image_(camera.image),
        normal_(normal),
        offset_(normal.dot(point)),
        depth_(point.z()),
        sigma_(camera.noise_scale * axialNoise(point.z())),
        column_(static_cast<int>(pixel % image_.width)),
        row_(static_cast<int>(pixel / image_.width)),
        ray_(point / point.z()),
        per_column_(camera.rays.x_scale),
        per_row_(camera.rays.y_scale) {
    // Where depth grows fastest, a whole pixel at a time in one direction.
    const double right = normal.x() * per_column_, down = normal.y() * per_row_;
    const double longer = std::max(std::abs(right), std::abs(down));
    right_ = right / longer, down_ = down / longer;
  }

  /// How many pixels the image stays on the plane, to the side of growing depth (1) or to the other (-1), up to what is
  /// measured off it; most at most, and as many where the image or the plane ends. What is missing tells nothing.
  int stepsOn(double side, int most) const {
    double before = depth_;
    for (int k = 1; k <= most; ++k) {
      const auto right = static_cast<int>(std::lround(side * k * right_));
      const auto down = static_cast<int>(std::lround(side * k * down_));
      const std::optional<double> expected = depthAt(right, down);
      if (!expected) return most;
      const double step = std::abs(*expected - before);
      before = *expected;
      const std::size_t i =
          static_cast<std::size_t>(row_ + down) * image_.width + static_cast<std::size_t>(column_ + right);
      if (image_.valid(i) && !isOn(image_.z[i], *expected, step)) return k - 1;
    }
    return most;
  }

 private:
  /// Of the plane, so many pixels on; nothing outside of the image and where the ray does not meet the plane.
  std::optional<double> depthAt(int right, int down) const {
    const int column = column_ + right, row = row_ + down;
    const bool inside =
        0 <= column && column < static_cast<int>(image_.width) && 0 <= row && row < static_cast<int>(image_.height);
    if (!inside) return std::nullopt;
    const Vec3 ray = ray_ + Vec3(right * per_column_, down * per_row_, 0.0);
    const double depth = offset_ / normal_.dot(ray);
    return depth > 0.0 && std::isfinite(depth) ? std::optional<double>(depth) : std::nullopt;
  }

  /// step: m, by which the depth changes from pixel to pixel
  bool isOn(double measured, double expected, double step) const {
    constexpr double kOfStep = 0.5, kDeviations = 2.0;
    return std::abs(measured - expected) < kOfStep * step + kDeviations * sigma_;
  }

  const Cloud& image_;
  const Vec3 normal_;
  const double offset_, depth_, sigma_;
  const int column_, row_;
  const Vec3 ray_;  ///< through the point, z = 1
  const double per_column_, per_row_;
  double right_, down_;
};

}  // namespace

bool fliesBetween(const ImageOfCamera& camera, std::uint32_t pixel, const Vec3& point, const Vec3& normal) {
  constexpr double kSteepest = 0.2;  // sine of the angle to the surface
  constexpr double kWidest = 7.0;    // px, of usual images
  if (!camera.rays.known || !(normal.head<2>().norm() > 0.0)) return false;
  if (!(std::abs(normal.dot(point)) < kSteepest * point.norm())) return false;
  const int widest = std::max(1, static_cast<int>(std::lround(kWidest * camera.share)));
  const Slope slope(camera, pixel, point, normal);
  const int behind = slope.stepsOn(1.0, widest);
  return behind < widest && behind + 1 + slope.stepsOn(-1.0, widest - behind) <= widest;
}

}  // namespace primitect
