// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Rings of pixels around points, and distances of places from other shapes; see clear_points.h.
#include "core/clear_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/axis_extent.h"
#include "core/far_sides.h"
#include "core/flat.h"
#include "core/float_range.h"
#include "core/pixel_ring.h"
#include "core/point_noise.h"
#include "core/ray_depth.h"
#include "core/seen_points.h"

namespace primitect {
namespace {

/// Points that are looked at together. Those of a list are spread over their shape, so that fewer are hardly farther
/// from others: with 128 the paper's scenes take .4 % more instructions.
constexpr std::size_t kPlacesAtOnce = 512;

/// In pixels the noise of a depth camera reaches about equally far from 0.5 to 1.5 m: three standard deviations are 3
/// pixels of an image 640 wide at 1 m. Measured on 20 tables: with 2 NEES of spheres is 2.7 instead of 1.1, with 4
/// curved shapes lie a quarter or more farther from the truth.
int ringRadius(const Cloud& cloud) { return std::max(2, static_cast<int>(std::lround(3.0 * cloud.width / 640.0))); }

/// A shape's rim is as wide as a wall can be whose far side is taken for the near one: times the ring's radius. With 2
/// NEES of the spheres and cones of tables is 1.5 and 1.2, without 1.7 and 1.4; with 3 and 4 errors are larger.
constexpr int kRim = 2;

/// One point in so many beside the surface is noticed: fewer are chance, and do no harm.
constexpr std::size_t kNoticed = 50;

/// A surface that is nearer to the cut lacks points on that side of it: standard deviations.
constexpr double kReachOfCut = 3.0;

/// A ball that holds what is within reach of some points.
struct Ball {
  float x, y, z, radius;

  /// reach: of each point (m).
  Ball(const float* px, const float* py, const float* pz, const float* reach, std::size_t count) {
    constexpr float kRounding = 1.001f;
    kernels::loops().balls(px, py, pz, count, count, {&x, &y, &z, &radius});
    radius = kRounding * (radius + *std::max_element(reach, reach + count));
  }

  bool meets(const kernels::FlatShape& shape, const ObservedPart& part) const {
    float distance;
    kernels::loops().distances(shape, &x, &y, &z, 1, &distance);
    return !(std::fabs(distance) > radius) && !(part.depth(x, y, z) < -radius);
  }
};

/// Places on a shape, with what is known of them so far.
struct PlacesOnShape {
  std::size_t count;
  float x[kPlacesAtOnce], y[kPlacesAtOnce], z[kPlacesAtOnce];
  float reach[kPlacesAtOnce];          ///< m
  std::uint32_t clear[kPlacesAtOnce];  ///< 1 or 0: as wide as what it is worked out from

  Ball ball() const { return {x, y, z, reach, count}; }
};

/// The places of points on the surface, which noise across it does not move: to leave out points by where they
/// themselves are would keep those that it moved away from the neighbour. Clear are those whose normal agrees.
void findPlaces(const Cloud& cloud, const CloudNormals& normals, const Detection& detection, const NoiseModel& noise,
                const std::uint32_t* points, PlacesOnShape& places) {
  constexpr double kReach = 3.5;  // standard deviations: both sides of where two shapes meet
  float *x = places.x, *y = places.y, *z = places.z;
  const bool by_normals = normals.taken && cloud.hasNormals();
  for (std::size_t k = 0; k < places.count; ++k) {
    const std::uint32_t i = points[k];
    x[k] = cloud.x[i], y[k] = cloud.y[i], z[k] = cloud.z[i];
    if (!by_normals) continue;
    // They come from all over the cloud: on their way while feet are found.
    __builtin_prefetch(&cloud.nx[i]), __builtin_prefetch(&cloud.ny[i]), __builtin_prefetch(&cloud.nz[i]);
  }
  const Feet<kPlacesAtOnce> feet(detection.shape, Vec3::Zero(), x, y, z, places.count);
  kernels::loops().tolerances(flattened(noise, kReach), z, places.count, places.reach);
  const float side = detection.concave ? -1.0f : 1.0f, least = static_cast<float>(std::cos(noise.angle));
  for (std::size_t k = 0; k < places.count; ++k) {
    const float away = feet.distance[k];
    x[k] -= away * feet.nx[k], y[k] -= away * feet.ny[k], z[k] -= away * feet.nz[k];
    places.clear[k] = 1;
    if (!by_normals) continue;
    const std::uint32_t i = points[k];
    const float away_from_sensor = cloud.nx[i] * cloud.x[i] + cloud.ny[i] * cloud.y[i] + cloud.nz[i] * cloud.z[i];
    const float turn = normals.towards_sensor && away_from_sensor > 0.0f ? -side : side;
    const float cosine = turn * (cloud.nx[i] * feet.nx[k] + cloud.ny[i] * feet.ny[k] + cloud.nz[i] * feet.nz[k]);
    places.clear[k] = cosine < least ? 0 : 1;  // a missing one says nothing
  }
}

/// Those within reach of another detection's observed part are not clear.
void leaveOutNear(const kernels::FlatShape& shape, const ObservedPart& part, PlacesOnShape& places) {
  float distance[kPlacesAtOnce], depth[kPlacesAtOnce];
  kernels::loops().distances(shape, places.x, places.y, places.z, places.count, distance);
  kernels::loops().depths(part.view(), places.x, places.y, places.z, places.count, depth);
  for (std::size_t k = 0; k < places.count; ++k) {
    const float reach = places.reach[k];
    const bool near = (std::fabs(distance[k]) < reach) & (depth[k] > -reach);
    places.clear[k] &= near ? 0u : 1u;
  }
}

/// The part where points of a list may be of this shape: as observed, but longer. Samples are too few to see where its
/// axis ends, least of all where they are sparse, and what lies on it beyond would turn others.
ObservedPart possiblePart(const Detection& detection) {
  constexpr double kLonger = 1.5;
  if (!hasAxis(kindOf(detection.shape))) return {detection.shape, detection.extent};
  Extent extent;  // which has no outline to copy
  extent.origin = detection.extent.origin, extent.rotation = detection.extent.rotation;
  extent.size = Vec3(0, 0, kLonger * detection.extent.size.z());
  return {detection.shape, extent};
}

}  // namespace

bool enoughClear(std::size_t clear, std::size_t all) {
  constexpr std::size_t kFewest = 100, kLeastPart = 4;
  return clear >= kFewest && kLeastPart * clear >= all;
}

ClearPoints::ClearPoints(const Cloud& cloud, const CloudNormals& normals, const std::vector<Detection>& detections,
                         const List<bool>& kept, const std::vector<std::uint32_t>& labels, List<bool> has_far_side,
                         const NoiseModel& noise, const DepthRange& cut)
    : cloud_(cloud),
      normals_(normals),
      detections_(detections),
      labels_(labels),
      noise_(noise),
      cut_(cut),
      has_far_side_(std::move(has_far_side)) {
  if (inImage()) return;
  for (std::uint32_t k = 0; k < detections.size(); ++k) {
    if (!kept.empty() && !kept[k]) continue;
    others_.push_back(k);
    shapes_.push_back(flattened(detections[k].shape, Vec3::Zero()));
    parts_.push_back(possiblePart(detections[k]));
  }
}

/// Of most shapes no point is that near to the cut, as the nearest and the farthest tell.
bool ClearPoints::mayEndBeside(const List<std::uint32_t>& points) const {
  if (points.empty()) return false;
  List<float> depths(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) depths[k] = cloud_.z[points[k]];
  const FloatRange range(depths.data(), depths.size());
  const double nearest = range.low, farthest = range.high;
  // What noise there is has no maximum between two depths.
  const double most = std::max(noise_.at({0.0, 0.0, nearest}), noise_.at({0.0, 0.0, farthest}));
  return cut_.endsWithin(2.0 * kReachOfCut * most, nearest) || cut_.endsWithin(2.0 * kReachOfCut * most, farthest);
}

bool ClearPoints::endsBeside(const Shape& shape, std::uint32_t point) const {
  const Vec3 here = cloud_.point(point);
  const double reach = kReachOfCut * noise_.at(here);
  if (!cut_.endsWithin(2.0 * reach, here.z())) return false;
  // By where its ray meets the surface: noise moves points, and what is below them, but no rays.
  const auto meets = [&](const auto& one) { return depthOn(opened(one), here / here.z(), here.z()); };
  return cut_.endsWithin(reach, std::visit(meets, shape).value_or(here.z()));
}

List<std::uint32_t> ClearPoints::surrounded(std::uint32_t label, const List<std::uint32_t>& points) const {
  const int radius = ringRadius(cloud_);
  const PixelRing ring(radius, cloud_), wide(kRim * radius, cloud_);
  const bool any_far = !has_far_side_.empty() && has_far_side_[label - 1], by_cut = mayEndBeside(points);
  const Shape& shape = detections_[label - 1].shape;
  List<std::uint32_t> result;
  result.reserve(points.size());
  for (const std::uint32_t i : points) {
    if (ring.meetsOther(label, labels_.data(), i) || (by_cut && endsBeside(shape, i))) continue;
    if (!any_far || !wide.meets(label | kFarSide, labels_.data(), i)) result.push_back(i);
  }
  return result;
}

List<std::uint32_t> ClearPoints::apart(std::size_t detection, const List<std::uint32_t>& points) const {
  List<std::uint32_t> result;
  result.reserve(points.size());
  PlacesOnShape places;
  for (std::size_t begin = 0; begin < points.size(); begin += kPlacesAtOnce) {
    places.count = std::min(kPlacesAtOnce, points.size() - begin);
    findPlaces(cloud_, normals_, detections_[detection], noise_, points.data() + begin, places);
    const Ball ball = places.ball();
    for (std::size_t k = 0; k < others_.size(); ++k) {
      if (others_[k] != detection && ball.meets(shapes_[k], parts_[k])) leaveOutNear(shapes_[k], parts_[k], places);
    }
    for (std::size_t k = 0; k < places.count; ++k) {
      if (places.clear[k]) result.push_back(points[begin + k]);
    }
  }
  return result;
}

List<std::uint32_t> ClearPoints::of(std::size_t detection, const List<std::uint32_t>& points) const {
  const auto label = static_cast<std::uint32_t>(detection + 1);
  List<std::uint32_t> result = inImage() ? surrounded(label, points) : apart(detection, points);
  return enoughClear(result.size(), points.size()) ? result : points;
}

ClearPoints::OnSurface::OnSurface(const ClearPoints& finder, std::size_t detection, const List<std::uint32_t>& clear)
    : finder_(finder), label_(static_cast<std::uint32_t>(detection + 1)), clear_(clear) {}

LabelledShape ClearPoints::OnSurface::labelled() const {
  const int radius = ringRadius(finder_.cloud_);
  return {finder_.cloud_, finder_.labels_, label_, radius, kRim * radius};
}

/// Most shapes have no false border: some of the points tell, and the others need not be asked. With half the share
/// that is noticed among all, as chance may have it. Takes 1.1 % of a frame's instructions less; the same figures on
/// 60 tables.
bool ClearPoints::OnSurface::mayHaveFalseBorder(const Shape& fit) {
  constexpr std::size_t kEnough = 512;
  const std::size_t every = clear_.size() / kEnough;
  if (every < 2) return true;
  if (!of_some_) {
    List<std::uint32_t> some;
    some.reserve(clear_.size() / every + 1);
    for (std::size_t k = 0; k < clear_.size(); k += every) some.push_back(clear_[k]);
    of_some_.emplace(labelled(), finder_.noise_, std::move(some));
  }
  return 2 * kNoticed * (of_some_->size() - of_some_->without(fit).size()) > of_some_->size();
}

List<std::uint32_t> ClearPoints::OnSurface::operator()(const Shape& fit) {
  if (!finder_.inImage() || kindOf(fit) == Kind::plane) return clear_;
  if (!mayHaveFalseBorder(fit)) return clear_;
  if (!of_all_) of_all_.emplace(labelled(), finder_.noise_, clear_);
  List<std::uint32_t> result = of_all_->without(fit);
  const bool noticed = kNoticed * (clear_.size() - result.size()) > clear_.size();
  return noticed && enoughClear(result.size(), clear_.size()) ? result : clear_;
}

}  // namespace primitect
