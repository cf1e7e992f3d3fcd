// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What an image shows where the surface of a shape should be.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "core/image_rays.h"
#include "core/point_noise.h"
#include "core/ray_depth.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// The image that is asked what it shows.
struct AskedImage {
  const Cloud& cloud;
  const ImageRays& rays;
  const DepthRange& range;  ///< outside of it, points of this cloud were made missing
  const PointNoise& sigma;  ///< m, noise of the distance to a surface, at a point
};

/// other: a little nearer. blot: missing, with the surface on both sides. hole: missing for no reason that is seen.
/// unknown: hidden, in a shadow, missing up to the border, or near a bound of the depth.
enum class Sight { surface, behind, other, blot, hole, unknown };

/// Looks at single pixels, where the surface of a cylinder or an opened cone should be.
template <class T>
class Looking {
 public:
  /// middle: m, a depth of the surface
  Looking(const T& shape, double middle, const AskedImage& image)
      : shape_(shape), middle_(middle), image_(image), cloud_(image.cloud) {}

  Sight at(int column, int row, const Vec3& expected) const {
    const std::size_t i = index(column, row);
    const double sigma = image_.sigma(expected);
    if (nearBound(expected, sigma)) return Sight::unknown;
    if (cloud_.isBeyond(i)) return Sight::behind;
    if (!cloud_.valid(i)) return inGap(column, row, expected, sigma);
    if (hides(i, expected, sigma)) return Sight::unknown;
    const double away = cloud_.z[i] - expected.z();
    if (std::abs(away) < kOnSurface * sigma) return Sight::surface;
    return away > 0.0 ? Sight::behind : Sight::other;
  }

 private:
  static constexpr double kOnSurface = 4.0;  // standard deviations, along the ray

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * cloud_.width + static_cast<std::size_t>(column);
  }

  /// Clearly nearer: not the surface with a bump.
  bool hides(std::size_t i, const Vec3& expected, double sigma) const {
    constexpr double kNearer = 12.0;  // standard deviations
    return cloud_.z[i] < expected.z() - kNearer * sigma;
  }

  /// Noise takes points beyond a bound, where they are missing.
  bool nearBound(const Vec3& expected, double sigma) const {
    constexpr double kDeviations = 3.0;
    return image_.range.endsWithin(kDeviations * sigma, expected.z());
  }

  /// The measured pixels on either side of a gap in a row or a column; 0: none.
  struct Gap {
    int before, after;  ///< px from the place in it

    int width() const { return before + after; }
    bool hasBoth() const { return before > 0 && after > 0; }
  };

  Gap gapAt(int column, int row, int right, int down) const {
    constexpr int kLongest = 200;  // px
    const auto next = [&](int step) {
      for (int away = 1; away <= kLongest; ++away) {
        const int c = column + away * step * right, r = row + away * step * down;
        if (c < 0 || c >= static_cast<int>(cloud_.width) || r < 0 || r >= static_cast<int>(cloud_.height)) return 0;
        if (cloud_.valid(index(c, r))) return away;
      }
      return 0;
    };
    return {next(-1), next(1)};
  }

  /// Clearly, as noise alone seldom takes a point so far off; with 4 deviations a calibration board whose dark squares
  /// are missing carries more than twice as many cones.
  bool showsSurface(int column, int row) const {
    constexpr double kClearly = 1.5;  // standard deviations, along the ray
    const std::size_t i = index(column, row);
    const std::optional<double> z = depthOn(shape_, image_.rays.through(column, row), middle_);
    return z && std::abs(cloud_.z[i] - *z) < kClearly * image_.sigma(cloud_.point(i));
  }

  /// What is dark or glossy has holes, with its surface on both sides. Clutter in tatters has something nearer or
  /// farther beside them.
  bool isBlot(const Gap& gap, int column, int row, int right, int down) const {
    constexpr double kWidest = 60.0;  // px, of usual images
    return gap.hasBoth() && gap.width() <= kWidest * shareOfUsualWindows(image_.rays) &&
           showsSurface(column - gap.before * right, row - gap.before * down) &&
           showsSurface(column + gap.after * right, row + gap.after * down);
  }

  /// Single pixels are missing everywhere; a projector beside the camera leaves a gap along the edge of what hides; and
  /// of what is missing up to the border nobody knows why: what hid may have been cut away.
  Sight inGap(int column, int row, const Vec3& expected, double sigma) const {
    constexpr int kWidestDropout = 8;  // px
    const Gap gap = gapAt(column, row, 1, 0);
    if (!gap.hasBoth() || gap.width() <= kWidestDropout) return Sight::unknown;
    if (isBlot(gap, column, row, 1, 0) || isBlot(gapAt(column, row, 0, 1), column, row, 0, 1)) return Sight::blot;
    const bool shadow = isShadow(column - gap.before, row, gap.before, expected, sigma) ||
                        isShadow(column + gap.after, row, gap.after, expected, sigma);
    return shadow ? Sight::unknown : Sight::hole;
  }

  /// A gap as wide as this may be the shadow of the pixel at its end.
  bool isShadow(int column, int row, int width, const Vec3& expected, double sigma) const {
    constexpr double kBaseline = 0.08;  // m, from the projector, or the second camera, to the camera: seldom more
    const std::size_t i = index(column, row);
    const double widest = kBaseline / std::abs(image_.rays.x_scale) * (1.0 / cloud_.z[i] - 1.0 / expected.z());
    return hides(i, expected, sigma) && width <= widest + 2.0;
  }

  const T& shape_;
  double middle_;
  const AskedImage& image_;
  const Cloud& cloud_;  // of the image
};

/// The surface faces the sensor with the side that is seen, and not at a grazing angle.
template <class T>
bool faces(const T& shape, bool concave, const Vec3& point) {
  constexpr double kLeastCosine = 0.3;
  const double cosine = -normalAt(shape, point).dot(point) / point.norm();
  return (concave ? -cosine : cosine) > kLeastCosine;
}

}  // namespace primitect
