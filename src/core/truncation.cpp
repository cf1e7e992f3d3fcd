// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Walks over the image from the border of a shape's points; see truncation.h.
#include "core/truncation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/axis_extent.h"
#include "core/observed_part.h"
#include "core/ray_depth.h"
#include "core/unseen_ends.h"
#include "kernels/loops.h"

namespace primitect {
namespace {

constexpr double kOnSurface = 3.0;  // standard deviations

struct Pixel {
  int column, row;
};

std::size_t indexOf(const Pixel& pixel, const Cloud& image) {
  return static_cast<std::size_t>(pixel.row) * image.width + static_cast<std::size_t>(pixel.column);
}

/// One walk along a row or column; what it passes is judged against the surface as it should be there.
template <class T>
class Walk {
 public:
  Walk(const Cloud& cloud, const ImageRays& rays, const DepthRange& range, const PointNoise& sigma, const T& shape)
      : cloud_(cloud), rays_(rays), range_(range), sigma_(sigma), shape_(shape) {}

  /// The bit of what ends the surface in this direction; 0 when it ends on its own, or nobody knows why.
  std::uint8_t from(Pixel pixel, const Pixel& step) {
    constexpr int kLongest = 200;  // px
    // Holes, and shadows beside an occluding edge, are this wide at most: f b (1 / z - 1 / z') = 20 px for a step from
    // 0.7 to 1.0 m.
    constexpr int kWidestGap = 24;
    depth_ = last_depth_ = cloud_.z[index(pixel)];
    int gap = 0;
    for (int length = 0; length < kLongest && gap <= kWidestGap; ++length) {
      pixel = {pixel.column + step.column, pixel.row + step.row};
      ++gap;
      if (!rays_.measures(pixel.column, pixel.row)) return kTruncatedByImage;
      const std::optional<double> expected = depthOn(shape_, rays_.through(pixel.column, pixel.row), depth_);
      if (!expected) return 0;
      depth_ = *expected;
      const std::size_t i = index(pixel);
      if (!cloud_.valid(i)) {
        if (outOfRange(pixel, gap)) return kTruncatedByDepth;
      } else if (onSurface(i)) {
        gap = 0;
        last_depth_ = depth_;
      } else if (hides(i, gap)) {
        return kTruncatedByOcclusion;
      } else if (++strangers_ > 2) {
        return 0;
      }
      if (gap == 0) strangers_ = 0;
    }
    return 0;
  }

 private:
  std::size_t index(const Pixel& pixel) const { return indexOf(pixel, cloud_); }

  /// Along the ray: on a slanted surface that is what the noise of the depth is, and not its distance.
  bool onSurface(std::size_t i) const { return std::abs(cloud_.z[i] - depth_) < kOnSurface * sigma_(cloud_.point(i)); }

  /// Noise lets the surface end a little before the bound, and farther into a gap it may have ended for other reasons.
  bool outOfRange(const Pixel& pixel, int gap) const {
    constexpr int kAtOnce = 3;  // px
    const double margin = kOnSurface * sigma_(depth_ * rays_.through(pixel.column, pixel.row));
    return gap <= kAtOnce && range_.endsWithin(margin, depth_);
  }

  /// Nearer than the surface, and than another could be that meets it where the gap began.
  bool hides(std::size_t i, int gap) const {
    constexpr double kNoise = 8.0;     // standard deviations, of which the surface may have begun to leave by 3 unseen
    constexpr double kSteepest = 3.0;  // depth by distance across: at 72 deg to the view
    const double across = gap * std::max(std::abs(rays_.x_scale), std::abs(rays_.y_scale)) * depth_;
    const double nearest = std::min(depth_, last_depth_ - kSteepest * across);
    return cloud_.z[i] < nearest - kNoise * sigma_(cloud_.point(i));
  }

  const Cloud& cloud_;
  const ImageRays& rays_;
  const DepthRange& range_;
  const PointNoise& sigma_;
  const T& shape_;
  double depth_ = 0.0;       ///< of the surface here
  double last_depth_ = 0.0;  ///< where a point was last seen on it
  int strangers_ = 0;        ///< pixels off the surface since the last one on it
};

/// From a pixel to the next one on a surface.
struct SurfaceStep {
  Vec3 from, step;  ///< m
};

/// By the surface alone: noise is wider than a pixel. Nothing where the next ray no longer meets it.
template <class T>
std::optional<SurfaceStep> surfaceStep(const T& shape, const ImageRays& rays, double depth, const Pixel& pixel,
                                       const Pixel& step) {
  const Vec3 here = rays.through(pixel.column, pixel.row);
  const Vec3 ahead = rays.through(pixel.column + step.column, pixel.row + step.row);
  const std::optional<double> from = depthOn(shape, here, depth);
  if (!from) return std::nullopt;
  const std::optional<double> to = depthOn(shape, ahead, *from);
  if (!to) return std::nullopt;
  return SurfaceStep{*from * here, *to * ahead - *from * here};
}

/// Bands of rows or columns with their outermost pixels: where walks start.
class Bands {
 public:
  static constexpr int kCount = 12;

  Bands(int low, int high) : low_(low), width_(std::max(high - low + 1, 1)) {}

  void add(int place, int value, const Pixel& pixel) {
    Band& band = bands_[static_cast<std::size_t>((place - low_) * kCount / width_)];
    if (!band.used || value < band.low.first) band.low = {value, pixel};
    if (!band.used || value > band.high.first) band.high = {value, pixel};
    band.used = true;
  }

  template <class Use>
  void each(const Use& use) const {
    for (const Band& band : bands_) {
      if (band.used) use(band.low.second, band.high.second);
    }
  }

 private:
  struct Band {
    std::pair<int, Pixel> low, high;
    bool used = false;
  };
  int low_, width_;
  std::array<Band, kCount> bands_;
};

/// Of some of the points: elsewhere on the surface they are no part of the extent.
List<Pixel> pixelsOn(const ObservedPart& part, const Cloud& cloud, const PointNoise& sigma,
                     const List<std::uint32_t>& points) {
  // More would only find borders that are a pixel farther out.
  constexpr std::size_t kMost = 600;
  float x[kMost], y[kMost], z[kMost], depth[kMost];
  List<Pixel> pixels;
  std::size_t count = 0;
  const std::size_t step = points.size() / kMost + 1;
  for (std::size_t k = 0; k < points.size(); k += step, ++count) {
    const std::uint32_t i = points[k];
    x[count] = cloud.x[i], y[count] = cloud.y[i], z[count] = cloud.z[i];
  }
  // All at once: sides of an outline are many.
  kernels::loops().depths(part.view(), x, y, z, count, depth);
  for (std::size_t k = 0; k < count; ++k) {
    if (!(depth[k] >= -kOnSurface * sigma({x[k], y[k], z[k]}))) continue;
    const std::uint32_t i = points[k * step];
    pixels.push_back({static_cast<int>(i % cloud.width), static_cast<int>(i / cloud.width)});
  }
  return pixels;
}

/// Start and direction of all walks.
List<std::pair<Pixel, Pixel>> startsOf(const List<Pixel>& pixels) {
  Pixel low = pixels.front(), high = pixels.front();
  for (const Pixel& p : pixels) {
    low = {std::min(low.column, p.column), std::min(low.row, p.row)};
    high = {std::max(high.column, p.column), std::max(high.row, p.row)};
  }
  Bands columns(low.column, high.column), rows(low.row, high.row);
  for (const Pixel& p : pixels) {
    columns.add(p.column, p.row, p);
    rows.add(p.row, p.column, p);
  }
  List<std::pair<Pixel, Pixel>> starts;
  const auto bothWays = [&starts](const Pixel& step) {
    return [&starts, step](const Pixel& first, const Pixel& last) {
      starts.push_back({first, {-step.column, -step.row}});
      starts.push_back({last, step});
    };
  };
  columns.each(bothWays({0, 1}));
  rows.each(bothWays({1, 0}));
  return starts;
}

/// The points reach a bound when the gap to it is no larger than those between them.
std::uint8_t depthBit(const Cloud& cloud, const DepthRange& range, const List<std::uint32_t>& points) {
  const auto byDepth = [&cloud](std::uint32_t a, std::uint32_t b) { return cloud.z[a] < cloud.z[b]; };
  const auto ends = std::minmax_element(points.begin(), points.end(), byDepth);
  const float nearest = cloud.z[*ends.first], farthest = cloud.z[*ends.second];
  constexpr float kSpacings = 3.0f, kShare = 0.01f;  // mean spacings; of the depth: noise, and a camera's rows
  const float margin = kSpacings * (farthest - nearest) / static_cast<float>(points.size()) + kShare * farthest;
  const bool reached =
      (range.max > 0.0f && farthest > range.max - margin) || (range.min > 0.0f && nearest < range.min + margin);
  return reached ? kTruncatedByDepth : 0;
}

}  // namespace

TruncationFinder::TruncationFinder(const Cloud& cloud, const ImageRays& rays, const DepthRange& range, PointNoise sigma)
    : cloud_(cloud), rays_(rays), range_(range), sigma_(std::move(sigma)) {}

Truncated TruncationFinder::find(const Shape& shape, const Extent& extent,
                                 const List<std::uint32_t>& inlier_points) const {
  const bool has_axis = hasAxis(kindOf(shape));
  Truncated truncated;
  if (!has_axis) truncated.unseen_ends = 0;
  if (inlier_points.empty()) return truncated;
  const auto unknown = [&]() {
    Truncated by_depth = truncated;
    by_depth.by |= depthBit(cloud_, range_, inlier_points);
    return by_depth;
  };
  if (!rays_.known) return unknown();
  const List<Pixel> pixels = pixelsOn(ObservedPart(shape, extent), cloud_, sigma_, inlier_points);
  if (pixels.empty()) return truncated;
  const auto starts = startsOf(pixels);
  std::array<std::size_t, 8> counts = {};
  const Kind kind = kindOf(shape);
  UnseenEnds ends(kind, extent);
  const auto walkAll = [&](const auto& any) {
    const auto& on = opened(any);
    for (const auto& [start, step] : starts) {
      const std::uint8_t end = Walk(cloud_, rays_, range_, sigma_, on).from(start, step);
      ++counts[end];
      if (kind == Kind::sphere) continue;
      const auto first = surfaceStep(on, rays_, cloud_.z[indexOf(start, cloud_)], start, step);
      if (first) ends.add(first->from, first->step, end);
    }
  };
  std::visit(walkAll, shape);
  // A pipe that runs slantwise into the border reaches it with an end: of two dozen walks one or two go along it.
  const std::uint8_t at_an_end = has_axis ? kTruncatedByImage : 0;
  const auto reached = [&](std::uint8_t bit) {
    const std::size_t walks = bit == at_an_end ? 24 : 10;
    return walks * counts[bit] >= starts.size();
  };
  // Where a list ends the camera may have ended, or a filter, or the thing itself.
  const std::uint8_t at_ends = ends.cutOffBy();
  if (!rays_.border_known && (reached(kTruncatedByImage) || (at_ends & kTruncatedByImage) != 0)) return unknown();
  truncated.by = at_ends;  // a narrow end has few of all walks, as that of a plank
  for (const std::uint8_t bit : {kTruncatedByImage, kTruncatedByDepth, kTruncatedByOcclusion}) {
    if (reached(bit)) truncated.by |= bit;
  }
  if (has_axis) truncated.unseen_ends = ends.bits();
  return truncated;
}

}  // namespace primitect
