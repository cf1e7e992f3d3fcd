// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Projection with the nearer point in front; see projected_image.h.
#include "core/projected_image.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/pixel_ring.h"
#include "core/random.h"

namespace primitect {
namespace {

/// Of a camera's points so few at either end are strays, and so few may be where no camera sees.
constexpr double kAside = 0.002;
/// More than this are no strays: the points were not seen from the origin.
constexpr double kSurelyAside = 0.05;

/// Bounds of x/z and y/z of the points that a camera can see.
struct View {
  float left, right, top, bottom;
  std::size_t points;  ///< how many these are
};

View viewOf(const Cloud& cloud) {
  constexpr float kWidest = 2.0f;  // tangent: beyond it no camera sees
  constexpr std::size_t kAtOnce = 8;
  const float *const x = cloud.x.data(), *const y = cloud.y.data(), *const z = cloud.z.data();
  float left[kAtOnce], right[kAtOnce], top[kAtOnce], bottom[kAtOnce];
  std::uint32_t seen[kAtOnce] = {};
  for (std::size_t lane = 0; lane < kAtOnce; ++lane) left[lane] = top[lane] = 1e9f, right[lane] = bottom[lane] = -1e9f;
  const auto look = [&](std::size_t i, std::size_t lane) {
    const float u = x[i] / z[i], v = y[i] / z[i];
    // Missing points are NaN, of which no comparison holds.
    const bool in = (z[i] > 0.0f) & (-kWidest < u) & (u < kWidest) & (-kWidest < v) & (v < kWidest);
    left[lane] = (in & (u < left[lane])) ? u : left[lane], right[lane] = (in & (u > right[lane])) ? u : right[lane];
    top[lane] = (in & (v < top[lane])) ? v : top[lane], bottom[lane] = (in & (v > bottom[lane])) ? v : bottom[lane];
    seen[lane] += in ? 1u : 0u;
  };
  std::size_t i = 0;
  for (; i + kAtOnce <= cloud.size(); i += kAtOnce) {
    for (std::size_t lane = 0; lane < kAtOnce; ++lane) look(i + lane, lane);
  }
  for (; i < cloud.size(); ++i) look(i, 0);
  return {*std::min_element(left, left + kAtOnce), *std::max_element(right, right + kAtOnce),
          *std::min_element(top, top + kAtOnce), *std::max_element(bottom, bottom + kAtOnce),
          std::accumulate(seen, seen + kAtOnce, std::size_t{0})};
}

/// How many of the pixels up to two steps around this one there are, and how many of these are measured.
struct Surroundings {
  std::size_t all = 0, measured = 0;

  void add(const Cloud& image, std::size_t pixel) {
    constexpr std::size_t kSteps = 2;
    const std::size_t row = pixel / image.width, column = pixel % image.width;
    const std::size_t bottom = std::min<std::size_t>(row + kSteps + 1, image.height);
    const std::size_t right = std::min<std::size_t>(column + kSteps + 1, image.width);
    for (std::size_t r = row - std::min(row, kSteps); r < bottom; ++r) {
      for (std::size_t c = column - std::min(column, kSteps); c < right; ++c) {
        ++all;
        measured += image.valid(r * image.width + c) ? 1 : 0;
      }
    }
  }
};

/// Narrows [first, last] to where these values lie, unless nearly all of it is needed.
void narrow(List<float>& values, float& first, float& last) {
  constexpr double kMargin = 0.1;  // of what is between the ends
  constexpr float kMuchWider = 1.5f;
  const auto aside = static_cast<std::ptrdiff_t>(kAside * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + aside, values.end());
  const float low = values[aside];
  std::nth_element(values.begin(), values.end() - 1 - aside, values.end());
  const float high = *(values.end() - 1 - aside), margin = static_cast<float>(kMargin) * (high - low);
  if (last - first <= kMuchWider * (high - low)) return;
  first = std::max(first, low - margin), last = std::min(last, high + margin);
}

/// Leaves a few points far aside out of the view: two of them would make the image as large as they like.
void leaveOutStrays(const Cloud& cloud, View& view) {
  constexpr int kLookedAt = 4096;
  constexpr std::size_t kFewest = 512;
  Random random(1);
  List<float> u, v;
  for (int k = 0; k < kLookedAt; ++k) {
    const std::size_t i = random.below(cloud.size());
    if (!(cloud.z[i] > 0.0f)) continue;  // NaN, a missing point, neither
    u.push_back(cloud.x[i] / cloud.z[i]);
    v.push_back(cloud.y[i] / cloud.z[i]);
  }
  if (u.size() < kFewest) return;
  narrow(u, view.left, view.right);
  narrow(v, view.top, view.bottom);
}

/// Of two points of one surface in a pixel the first or the last one, half and half: in lists that are ordered by
/// depth, as those of voxel grids, the first one is always the one that noise moved towards the sensor. By it planes of
/// tables in voxels of 5 mm were .5 mm too near, without .03 mm off (compare --set tabletop --seeds 300:20 --voxel
/// 0.005). With a fifth of the pixels (--keep 0.2 --seeds 2400:60 --algorithm-seeds 1,2) precision and recall are 95.5
/// / 100 %, with the first one 96.7 / 99.3, with the one nearest to the pixel's middle 93.9 / 99.7.
bool firstStays(std::uint32_t pixel) { return (pixel * 2654435761U >> 16 & 1U) != 0; }

}  // namespace

bool isSparse(const Cloud& image) {
  constexpr int kTries = 4096;
  constexpr double kDense = 0.6, kEnough = 256 * 25;
  Random random(1);
  Surroundings seen;
  for (int k = 0; k < kTries && static_cast<double>(seen.all) < kEnough; ++k) {
    const std::size_t pixel = random.below(image.size());
    if (image.valid(pixel)) seen.add(image, pixel);
  }
  return static_cast<double>(seen.measured) < kDense * static_cast<double>(seen.all);
}

void ProjectedImage::project(const Cloud& cloud, float left, float top, float pitch) {
  // Times the depth: of two points this near each other either stays. The nearer one would be the one that noise
  // moved towards the sensor.
  constexpr float kSameSurface = 1.02f;
  const auto columns = static_cast<float>(image_.width), rows = static_cast<float>(image_.height);
  pixel_.assign(cloud.size(), kNoPixel);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float column = (cloud.x[i] / cloud.z[i] - left) / pitch, row = (cloud.y[i] / cloud.z[i] - top) / pitch;
    const bool inside = 0.0f <= column && column < columns && 0.0f <= row && row < rows;
    if (!inside || !(cloud.z[i] > 0.0f)) continue;  // NaN, a missing point, neither
    const std::uint32_t pixel = static_cast<std::uint32_t>(row) * image_.width + static_cast<std::uint32_t>(column);
    pixel_[i] = pixel;
    const float there = image_.z[pixel];
    const bool behind = cloud.z[i] > kSameSurface * there, beside = there <= kSameSurface * cloud.z[i];
    if (behind || (beside && firstStays(pixel))) continue;  // NaN, an empty pixel, holds for neither
    if (!image_.valid(pixel)) ++image_.valid_count;
    image_.x[pixel] = cloud.x[i], image_.y[pixel] = cloud.y[i], image_.z[pixel] = cloud.z[i];
  }
}

/// One of the pixels around this one, or itself, holds a point that is not clearly in front of this depth.
bool ProjectedImage::isSeenBeside(std::uint32_t pixel, float depth, float behind) const {
  const PixelBlock block = blockAround(image_, pixel);
  for (std::size_t r = block.top; r < block.bottom; ++r) {
    for (std::size_t c = block.left; c < block.right; ++c) {
      if (depth <= behind * image_.z[r * image_.width + c]) return true;
    }
  }
  return false;
}

/// More points lie behind others than a few. Where a pixel is across an edge, what is behind is seen beside it. Of
/// lists of 15 depth cameras, thinned out to a thirtieth or in voxels of 0.5 to 2 cm, none hides so many; of their
/// clouds in frames on the floor below two thirds are told by this, or by points behind or far aside.
bool ProjectedImage::hidesMany(const Cloud& cloud, float pitch) const {
  constexpr std::size_t kLookedAt = 16384;
  // A pixel of a surface at a steep angle is as deep as five of them are wide.
  const float behind = 1.0f + 0.01f + 5.0f * pitch;  // times the depth of what is in front
  const double allowed = std::min(0.01, 0.001 + 0.4 * pitch);
  std::size_t hidden = 0, seen = 0;
  for (std::size_t i = 0; i < cloud.size(); i += cloud.size() / kLookedAt + 1) {
    if (pixel_[i] == kNoPixel) continue;
    ++seen;
    hidden += isSeenBeside(pixel_[i], cloud.z[i], behind) ? 0 : 1;
  }
  const double expected = allowed * static_cast<double>(seen);
  return static_cast<double>(hidden) > expected + 3.0 * std::sqrt(expected);
}

bool ProjectedImage::make(const Cloud& cloud) {
  constexpr double kLeastKept = 0.5, kMore = 1.2;  // of the points with different rays; times as before
  constexpr int kTimes = 5;
  seen_from_origin_ = true;
  if (cloud.valid_count == 0 || (cloud.organized() && !isSparse(cloud))) return false;
  View view = viewOf(cloud);
  seen_from_origin_ = static_cast<double>(view.points) >= (1.0 - kSurelyAside) * cloud.valid_count;
  if (static_cast<double>(view.points) < (1.0 - kAside) * cloud.valid_count) return false;
  leaveOutStrays(cloud, view);
  const float width = view.right - view.left, height = view.bottom - view.top;
  if (!(width > 0.0f && height > 0.0f)) return false;
  const double points = cloud.valid_count, most_pixels = std::max(8.0 * points, 1048576.0);
  double rays = points, before = 0.0, pixel_size = width * height / rays;
  for (int time = 0; time < kTimes; ++time) {
    const auto pitch = static_cast<float>(std::sqrt(pixel_size));
    const double columns = std::floor(width / pitch) + 1.0, rows = std::floor(height / pitch) + 1.0;
    // Points along a line fill no image.
    if (!(columns * rows < most_pixels && columns < points && rows < points)) return false;
    image_.reset(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), false);
    project(cloud, view.left, view.top, pitch);
    const double held = image_.valid_count;
    // Rows far apart, as of a laser scanner, leave the windows of such an image empty.
    if (held >= kLeastKept * rays) {
      seen_from_origin_ = !hidesMany(cloud, pitch);
      return seen_from_origin_ && !isSparse(image_);
    }
    if (held < kMore * before) {
      // Finer pixels part no more points: those that are left share their rays.
      rays = held, before = 0.0, pixel_size = width * height / rays;
    } else {
      // Most of what is in view is empty.
      pixel_size *= held / rays, before = held;
    }
  }
  return false;
}

List<std::size_t> ProjectedImage::pointsOfLabels(const std::vector<std::uint32_t>& labels, std::size_t most) const {
  List<std::size_t> of_label(most + 1, 0);
  for (const std::uint32_t pixel : pixel_) {
    const std::uint32_t label = pixel == kNoPixel ? 0 : labels[pixel];
    if (label <= most) ++of_label[label];
  }
  of_label.erase(of_label.begin());
  return of_label;
}

}  // namespace primitect
