// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// x / z is linear in the column, y / z in the row; see image_rays.h.
#include "core/image_rays.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace primitect {
namespace {

/// Least squares y = offset + scale * x.
struct Line {
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  void add(double at, double value) {
    count += 1.0, x += at, y += value, xx += at * at, xy += at * value, yy += value * value;
  }
  double spread() const { return xx - x * x / count; }
  /// Of the variance of y; NaN where x or y does not vary.
  double shareTold() const { return scale() * scale() * spread() / (yy - y * y / count); }
  double scale() const { return (xy - x * y / count) / spread(); }
  double offset() const { return (y - scale() * x) / count; }
  /// Root mean square of what is left, in units of x: pixels.
  double misfit() const {
    const double rest = yy - y * y / count - scale() * scale() * spread();
    return std::sqrt(std::max(rest, 0.0) / count) / std::abs(scale());
  }
};

/// What column and row tell of x/z and y/z; crossed: row and column.
struct Lines {
  Line of_x, of_y;

  Lines(const Cloud& cloud, std::size_t step, bool crossed) {
    for (std::size_t i = 0; i < cloud.size(); i += step) {
      if (!cloud.valid(i) || !(cloud.z[i] > 0.0f)) continue;
      const auto column = static_cast<double>(i % cloud.width), row = static_cast<double>(i / cloud.width);
      of_x.add(crossed ? row : column, static_cast<double>(cloud.x[i]) / cloud.z[i]);
      of_y.add(crossed ? column : row, static_cast<double>(cloud.y[i]) / cloud.z[i]);
    }
  }
  double misfit() const { return std::max(of_x.misfit(), of_y.misfit()); }
  bool fit() const {
    constexpr double kLargestMisfit = 1.0 / 3.0;
    return of_x.misfit() < kLargestMisfit && of_y.misfit() < kLargestMisfit;
  }
  bool tellNearlyAll() const {
    constexpr double kLeast = 0.95;
    return !(of_x.shareTold() < kLeast || of_y.shareTold() < kLeast);
  }
};

bool anyInColumn(const Cloud& cloud, int column) {
  for (std::size_t i = column; i < cloud.size(); i += cloud.width) {
    if (cloud.valid(i)) return true;
  }
  return false;
}

bool anyInRow(const Cloud& cloud, int row) {
  for (std::size_t i = 0; i < cloud.width; ++i) {
    if (cloud.valid(static_cast<std::size_t>(row) * cloud.width + i)) return true;
  }
  return false;
}

/// Sensors measure nothing in the outermost few percent of their image. A wider empty margin is an empty scene.
void findBorder(const Cloud& cloud, ImageRays& rays) {
  constexpr double kWidestMargin = 0.05;
  const int width = static_cast<int>(cloud.width), height = static_cast<int>(cloud.height);
  const int margin_x = static_cast<int>(kWidestMargin * width), margin_y = static_cast<int>(kWidestMargin * height);
  const auto empty = [](int count, const auto& used) {
    int lines = 0;
    while (lines <= count && !used(lines)) ++lines;
    return lines <= count ? lines : 0;
  };
  rays.first_column = empty(margin_x, [&](int k) { return anyInColumn(cloud, k); });
  rays.last_column = width - 1 - empty(margin_x, [&](int k) { return anyInColumn(cloud, width - 1 - k); });
  rays.first_row = empty(margin_y, [&](int k) { return anyInRow(cloud, k); });
  rays.last_row = height - 1 - empty(margin_y, [&](int k) { return anyInRow(cloud, height - 1 - k); });
}

}  // namespace

bool isOfPixels(double height_over_width) {
  constexpr double kLongest = 4.5;
  return height_over_width < kLongest && height_over_width > 1.0 / kLongest;
}

PixelPitch pitchOf(const ImageRays& rays) {
  constexpr double kLargestMisfit = 0.05;  // px
  if (!rays.known || rays.misfit > kLargestMisfit) return {};
  return {rays.x_scale, rays.y_scale};
}

ImageRays findRays(const Cloud& cloud) {
  ImageRays rays;
  if (!cloud.organized() || cloud.valid_count == 0) return rays;
  // More pixels would tell no more, and each is a miss of the cache.
  constexpr std::uint32_t kEnough = 512;
  constexpr double kFewest = 10.0;
  std::size_t step = std::max<std::size_t>(1, cloud.valid_count / kEnough);
  while (std::gcd(step, static_cast<std::size_t>(cloud.width)) > 1) ++step;  // then it visits all columns
  const Lines lines(cloud, step, false);
  if (lines.of_x.count < kFewest) return rays;
  rays.known = lines.fit();
  rays.seen_from_origin = rays.known || lines.tellNearlyAll() || Lines(cloud, step, true).fit();
  if (!rays.known) return rays;
  rays.misfit = lines.misfit();
  rays.x_offset = lines.of_x.offset(), rays.x_scale = lines.of_x.scale();
  rays.y_offset = lines.of_y.offset(), rays.y_scale = lines.of_y.scale();
  findBorder(cloud, rays);
  return rays;
}

double shareOfUsualWindows(const ImageRays& rays) {
  constexpr double kUsualFocalLength = 525.0;  // px
  if (!rays.known) return 1.0;
  // Of an image of which only every fourth row was kept the two differ.
  return std::min(1.0, 1.0 / (kUsualFocalLength * std::sqrt(std::abs(rays.x_scale * rays.y_scale))));
}

}  // namespace primitect
