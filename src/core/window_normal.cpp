// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What makes a fitted window a normal; see window_normal.h. The fit itself is kernels/window_loops.inc.
#include "core/window_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/noise.h"
#include "kernels/loops.h"

namespace primitect {
namespace {

constexpr double kTolerance = 3.0;  // standard deviations

kernels::WindowTask taskAt(std::uint32_t pixel, const Vec3& center, int half_width, const PixelPitch& pitch,
                           double noise_scale) {
  // Of d (window_loops.inc), nearly a share of the depth: more is another surface, at any slope that can be fitted.
  constexpr float kLargestJump = 0.04f;
  constexpr int kFewestAtStart = 6;
  kernels::WindowTask task = {};
  task.pixel = pixel;
  task.half_width = std::min(static_cast<std::size_t>(half_width), kernels::kLargestHalfWidth);
  task.inner_half_width = (task.half_width + 1) / 2;
  task.depth = static_cast<float>(center.z());
  task.u = static_cast<float>(center.x() / center.z());
  task.v = static_cast<float>(center.y() / center.z());
  task.largest_jump = kLargestJump;
  task.tolerance = static_cast<float>(kTolerance * noise_scale * axialNoise(center.z()) / center.z());
  task.fewest_at_start = kFewestAtStart;
  task.u_per_column = static_cast<float>(pitch.u);
  task.v_per_row = static_cast<float>(pitch.v);
  return task;
}

/// Of d by what its slope is above that of gentle planes (toleranceOf()), for what a camera errs sideways, as Nguyen et
/// al. (noise.h) measured. Of walls at 75 deg to the view in recorded frames the depth has 2.4 times its noise. Without
/// it sides of boxes at 76 to 81 deg lack many of their normals, and at 80 deg go missing (test_frames steep_faces).
/// Needs the pitch.
float lateralTolerance(const PixelPitch& pitch) {
  constexpr double kSideways = 2.0;  // px
  return static_cast<float>(kTolerance * kSideways * pitch.u);
}

/// Holds the centre's surface, of enough pixels.
bool usable(const kernels::WindowPlane& plane, const kernels::WindowTask& task) {
  constexpr double kSmallestShare = 0.25;  // of the window, on the centre's surface
  const double width = 2.0 * static_cast<double>(task.half_width) + 1.0;
  const int needed = std::max(6, static_cast<int>(kSmallestShare * width * width));
  return plane.used >= needed && std::abs(plane.c) < static_cast<double>(toleranceOf(task, plane));
}

/// The centre, moved this share of the way to the mean depth of the pixels around it that lie on the plane, each seen
/// along the plane: a quarter of the window, 25 pixels of usual images a metre away, 9 farther away.
Vec3 towardsMean(double steadying, const kernels::PointImage& image, kernels::WindowTask task,
                 const kernels::WindowPlane& plane, const Vec3& center) {
  constexpr std::size_t kShare = 4;
  if (steadying == 0.0) return center;
  task.half_width = std::max<std::size_t>((task.half_width + kShare / 2) / kShare, 1);
  // d = depth / z - 1, of which the centre has 0.
  return center / (1.0 + steadying * kernels::loops().offsetInWindow(image, task, plane));
}

/// A window that reaches beyond a limb or an occluder holds pixels of one side: there its normal is the surface's. In
/// the plane through the point, whose noise it then shares. 1 + a u + b v + c is the mean of depth / z, above 0.
Vec3 placeOf(const kernels::WindowPlane& plane, const kernels::WindowTask& task, const Vec3& point,
             const Vec3& direction) {
  const double z = task.depth / (1.0 + plane.a * plane.u + plane.b * plane.v + plane.c);
  const Vec3 way = Vec3((task.u + plane.u) * z, (task.v + plane.v) * z, z) - point;
  return point + way - way.dot(direction) * direction;
}

/// What the pixels of a window are off a plane, every second one of every second row.
struct WindowErrors {
  static constexpr std::size_t kEvery = 2, kMost = kernels::kLargestHalfWidth + 1;
  std::array<double, kMost * kMost> u, v, error;
  std::array<std::size_t, kMost * kMost> place;  // in rows of kMost
  std::size_t count = 0;

  WindowErrors(const Cloud& image, const kernels::WindowTask& task, const kernels::WindowPlane& plane) {
    const std::size_t column = task.pixel % image.width, row = task.pixel / image.width, half = task.half_width;
    // The row and column of the centre are among them: others may be missing throughout.
    const auto low = [half](std::size_t at) { return at < half ? at % kEvery : at - half + half % kEvery; };
    const auto high = [half](std::size_t at, std::size_t size) { return std::min(at + half, size - 1); };
    const std::size_t top = low(row), left = low(column);
    for (std::size_t y = top; y <= high(row, image.height); y += kEvery) {
      for (std::size_t x = left; x <= high(column, image.width); x += kEvery) {
        const std::size_t k = y * image.width + x;
        const double inverse = 1.0 / image.z[k];
        u[count] = image.x[k] * inverse - task.u, v[count] = image.y[k] * inverse - task.v;
        error[count] = task.depth * inverse - 1.0 - plane.a * u[count] - plane.b * v[count] - plane.c;
        place[count] = (y - top) / kEvery * kMost + (x - left) / kEvery;
        count += std::abs(error[count]) < task.tolerance ? 1 : 0;
      }
    }
  }

  /// Takes out of the errors what goes with this function of u and v: one after the other, all of it where the window
  /// is whole.
  template <class Function>
  void takeOut(const Function& function) {
    double mean = 0.0, squares = 0.0, products = 0.0;
    for (std::size_t k = 0; k < count; ++k) mean += function(u[k], v[k]) / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double value = function(u[k], v[k]) - mean;
      squares += value * value, products += value * error[k];
    }
    const double share = squares > 0.0 ? products / squares : 0.0;
    for (std::size_t k = 0; k < count; ++k) error[k] -= share * (function(u[k], v[k]) - mean);
  }

  /// Standard deviation, after so many functions were taken out; nothing where few pixels tell it.
  std::optional<double> deviation(std::size_t taken) const {
    constexpr std::size_t kFewest = 12;
    if (count < kFewest) return std::nullopt;
    double squares = 0.0;
    for (std::size_t k = 0; k < count; ++k) squares += error[k] * error[k];
    return std::sqrt(squares / static_cast<double>(count - taken));
  }

  /// Correlation of the errors of pixels that are kEvery apart in a row or a column; nothing where few tell it.
  std::optional<double> likeness() const {
    constexpr std::size_t kFewest = 24;
    std::array<double, kMost * kMost> in_place;
    in_place.fill(std::numeric_limits<double>::quiet_NaN());
    double squares = 0.0, products = 0.0, pairs = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      in_place[place[k]] = error[k];
      squares += error[k] * error[k] / static_cast<double>(count);
    }
    const auto add = [&](std::size_t a, std::size_t b) {
      const double product = in_place[a] * in_place[b];
      if (product == product) products += product, pairs += 1.0;
    };
    for (std::size_t k = 0; k < count; ++k) {
      if (place[k] % kMost != kMost - 1) add(place[k], place[k] + 1);
      if (place[k] / kMost != kMost - 1) add(place[k], place[k] + kMost);
    }
    if (pairs < kFewest || !(squares > 0.0)) return std::nullopt;
    return products / (pairs * squares);
  }
};

}  // namespace

std::optional<WindowNormal> windowNormal(const Cloud& cloud, std::uint32_t pixel, int half_width,
                                         const PixelPitch& pitch, double noise_scale) {
  return windowNormal(cloud, pixel, cloud.point(pixel), half_width, pitch, noise_scale);
}

std::optional<WindowNormal> windowNormal(const Cloud& image, std::uint32_t pixel, const Vec3& center, int half_width,
                                         const PixelPitch& pitch, double noise_scale, double steadying) {
  if (!(center.z() > 0.0)) return std::nullopt;
  kernels::WindowTask task = taskAt(pixel, center, half_width, pitch, noise_scale);
  task.tolerance_per_slope = lateralTolerance(pitch);
  const kernels::PointImage points = {image.x.data(), image.y.data(), image.z.data(), image.width, image.height};
  const kernels::WindowPlane plane = kernels::loops().fitWindow(points, task);
  if (!usable(plane, task)) return std::nullopt;
  // 1/z = (a (u - task.u) + b (v - task.v) + c + 1) / depth is the plane n.p = 1 with this n times the depth.
  const Vec3 normal(plane.a, plane.b, 1.0 + plane.c - plane.a * task.u - plane.b * task.v);
  // a and b turn the plane; c is known much better.
  const double noise = noise_scale * axialNoise(center.z()) / center.z() * std::sqrt(plane.variance) / normal.norm();
  const Vec3 direction = -normal.normalized();
  const Vec3 point = towardsMean(steadying, points, task, plane, center);
  return WindowNormal{direction, point, placeOf(plane, task, point, direction), noise};
}

std::optional<WindowNoise> windowNoise(const Cloud& image, std::uint32_t pixel, int half_width,
                                       const PixelPitch& pitch) {
  constexpr double kMostNoise = 4.0;  // what strays three standard deviations of it is another surface
  const Vec3 center = image.point(pixel);
  if (!(center.z() > 0.0)) return std::nullopt;
  const kernels::WindowTask task = taskAt(pixel, center, half_width, pitch, kMostNoise);
  const kernels::PointImage points = {image.x.data(), image.y.data(), image.z.data(), image.width, image.height};
  const kernels::WindowPlane plane = kernels::loops().fitWindow(points, task);
  if (!usable(plane, task)) return std::nullopt;
  WindowErrors off(image, task, plane);
  off.takeOut([](double u, double) { return u * u; });
  off.takeOut([](double, double v) { return v * v; });
  off.takeOut([](double u, double v) { return u * v; });
  const std::optional<double> deviation = off.deviation(3);
  if (!deviation) return std::nullopt;
  return WindowNoise{*deviation * center.z() / axialNoise(center.z()), off.likeness()};
}

}  // namespace primitect
