// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Asks the image at a grid of pixels within the outline; see open_ball.h.
#include "core/open_ball.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace primitect {
namespace {

enum class Place { deep, beyond, far_side, other };

/// What a pixel shows; nothing where its ray passes the ball, or meets its limb, where noise decides what is behind.
std::optional<Place> placeAt(int column, int row, const Sphere& ball, const AskedImage& image) {
  constexpr double kWithin = 0.9;              // of the radius, from the middle of the outline
  constexpr double kBehind = 0.2;              // of the radius, behind the front: an egg is no ring
  constexpr double kDeep = 0.75, kOut = 1.25;  // of the radius, from the center: walls of bowls are between these
  constexpr double kDeviations = 6.0;          // of the noise
  const Vec3 ray = image.rays.through(column, row).normalized();
  const double along = ray.dot(ball.center);
  const double across = (ball.center - along * ray).norm();
  if (!(across < kWithin * ball.radius)) return std::nullopt;
  const double half = std::sqrt(ball.radius * ball.radius - across * across);
  const std::size_t i = static_cast<std::size_t>(row) * image.cloud.width + static_cast<std::size_t>(column);
  const bool ends_before_bound = !(image.range.max > 0.0f) || (along + half) * ray.z() < image.range.max;
  if (image.cloud.isBeyond(i) && ends_before_bound) return Place::beyond;
  if (!image.cloud.valid(i)) return Place::other;
  const Vec3 point = image.cloud.point(i), front = (along - half) * ray;
  const double clearly = std::max(kBehind * ball.radius, kDeviations * image.sigma(front));
  if ((point - front).dot(ray) < clearly) return Place::other;
  const double away = (point - ball.center).norm() / ball.radius;
  if (away < kDeep) return Place::deep;
  if (point.dot(ray) < along) return Place::other;
  return away < kOut ? Place::far_side : Place::beyond;
}

/// Pixels of an image, those at the ends included.
struct Span {
  int first, last;

  int count() const { return std::max(0, last - first + 1); }
};

/// Between two places in a row or column of so many pixels.
Span spanOf(double a, double b, std::uint32_t count) {
  const auto [low, high] = std::minmax(a, b);
  const double last = static_cast<double>(count) - 1.0;
  return {static_cast<int>(std::clamp(std::ceil(low), 0.0, last + 1.0)),
          static_cast<int>(std::clamp(std::floor(high), -1.0, last))};
}

}  // namespace

SightsOfBall sightsOf(const Sphere& ball, const AskedImage& image) {
  constexpr double kPlaces = 400.0, kFewest = 50.0;  // of the box around the outline; within the outline
  const ImageRays& rays = image.rays;
  if (!rays.known || !(ball.center.z() > ball.radius)) return {};
  const Vec3 reach(ball.radius, ball.radius, 0.0);  // the outline of a near ball is wider: its limb tells nothing
  const Eigen::Vector2d from = rays.pixelOf(ball.center - reach), to = rays.pixelOf(ball.center + reach);
  const Span columns = spanOf(from.x(), to.x(), image.cloud.width);
  const Span rows = spanOf(from.y(), to.y(), image.cloud.height);
  const double area = static_cast<double>(columns.count()) * static_cast<double>(rows.count());
  const int step = std::max(1, static_cast<int>(std::sqrt(area / kPlaces)));
  double all = 0.0, of[4] = {};
  for (int row = rows.first + step / 2; row <= rows.last; row += step) {
    for (int column = columns.first + step / 2; column <= columns.last; column += step) {
      const std::optional<Place> place = placeAt(column, row, ball, image);
      if (!place) continue;
      all += 1.0;
      of[static_cast<std::size_t>(*place)] += 1.0;
    }
  }
  if (all < kFewest) return {};
  const auto share = [&](Place place) { return of[static_cast<std::size_t>(place)] / all; };
  return {share(Place::deep), share(Place::beyond), share(Place::far_side)};
}

bool isOpen(const Sphere& ball, const AskedImage& image) {
  constexpr double kDeep = 0.15, kThrough = 0.6;
  const SightsOfBall sights = sightsOf(ball, image);
  const bool into = sights.deep > kDeep && sights.far_side < 0.5 * sights.deep;
  return into || (sights.deep + sights.beyond > kThrough && sights.far_side < 0.5 * kDeep);
}

}  // namespace primitect
