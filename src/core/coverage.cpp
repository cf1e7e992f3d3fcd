// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shares of areas by probing them, and arcs from the gaps between angles; see coverage.h.
#include "core/coverage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/frame_memory.h"
#include "core/random.h"
#include "kernels/loops.h"

namespace primitect {
namespace {

using Vec2 = Eigen::Vector2d;

/// A share of one half is then known to 0.05, of evenly spread ones. Twice as many take .8 % more of a frame.
constexpr std::size_t kProbes = 64;
/// Places of a plane that tell how its outline cuts what lies around a probe; every second one is a probe.
constexpr std::size_t kPlaces = 2 * kProbes;
/// Prime: the step through the points is then seldom in time with the rows of an image.
constexpr std::size_t kMostInliers = 397;
/// Inliers around a probe: enough that chance leaves no hole, see covered().
constexpr double kNeighbors = 24.0;

/// Places with weights, filled up to whole lanes with such that weigh nothing.
struct WeightedPlaces {
  List<float> x, y, z, weight;

  void add(const Eigen::Vector3f& place, float weight_here) {
    x.push_back(place.x()), y.push_back(place.y()), z.push_back(place.z());
    weight.push_back(weight_here);
  }
  void fillUp() {
    while (x.size() % kernels::kLanes != 0) add(Eigen::Vector3f::Zero(), 0.0f);
  }
};

/// What lies around a probe: weighted sum of the offsets, and of the weights.
struct Around {
  Eigen::Vector3f sum;
  float weight;

  Around(const Eigen::Vector3f& probe, float reach, const WeightedPlaces& places) {
    const kernels::FlatProbe flat = {probe.x(), probe.y(), probe.z(), reach * reach};
    const kernels::FlatAround around = kernels::loops().around(flat, places.x.data(), places.y.data(), places.z.data(),
                                                               places.weight.data(), places.x.size());
    sum = {around.x, around.y, around.z};
    weight = around.weight;
  }
  Eigen::Vector3f mean() const { return sum / weight; }
};

/// The probe lies within what the inliers cover, not beside it. On a straight border they fill half of the disc, whose
/// centroid is 4 / (3 pi) of the reach away from its middle; `expected` is the centroid of a disc full of inliers. With
/// 12 inliers, which scatter by 0.5 / sqrt(12), 1.3 % of the probes in their midst are taken for uncovered, with 24
/// none.
bool covered(const Around& inliers, const Eigen::Vector3f& expected, float reach) {
  constexpr auto kHalfDisc = static_cast<float>(4.0 / (3.0 * M_PI));
  return inliers.weight > 0.0f && (inliers.mean() - expected).norm() < kHalfDisc * reach;
}

/// Directions all over the sphere, evenly spread (spherical Fibonacci lattice).
std::vector<Eigen::Vector3f> probeDirections() {
  const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  std::vector<Eigen::Vector3f> directions;
  for (std::size_t k = 0; k < kProbes; ++k) {
    const double z = 1.0 - (2.0 * static_cast<double>(k) + 1.0) / kProbes;
    const double radius = std::sqrt(1.0 - z * z), angle = golden_angle * static_cast<double>(k);
    directions.push_back(Vec3(radius * std::cos(angle), radius * std::sin(angle), z).cast<float>());
  }
  return directions;
}

double coverageOf(const Sphere& sphere, const Extent&, const SeenPoints& inliers, Density) {
  static const std::vector<Eigen::Vector3f> kDirections = probeDirections();
  const SomePoints<kMostInliers> some(inliers);
  const auto feet = Feet<SomePoints<kMostInliers>::kRoom>(sphere, some);
  WeightedPlaces seen;
  // Towards the limb a camera's points are sparser on the surface.
  constexpr float kLeastCosine = 0.2f;
  for (std::size_t k = 0; k < some.count; ++k) {
    const Eigen::Vector3f direction(feet.nx[k], feet.ny[k], feet.nz[k]);
    const Eigen::Vector3f ray = some.point(k).cast<float>().normalized();
    seen.add(direction, 1.0f / std::max(std::abs(direction.dot(ray)), kLeastCosine));
  }
  seen.fillUp();
  // A cap of this reach (rad) is reach^2 / 4 of the sphere. A sensor sees less than half of it.
  constexpr double kSeen = 0.45, kWidest = 0.8;
  const auto reach =
      static_cast<float>(std::min(kWidest, std::sqrt(4.0 * kNeighbors * kSeen / static_cast<double>(some.count))));
  std::size_t hits = 0;
  for (const Eigen::Vector3f& probe : kDirections) {
    Around around(probe, reach, seen);
    // Across the probe: along it the cap's own bulge would count.
    around.sum -= around.sum.dot(probe) * probe;
    hits += covered(around, Eigen::Vector3f::Zero(), reach) ? 1 : 0;
  }
  return static_cast<double>(hits) / kProbes;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The convex hull in the plane's own coordinates; of at least one corner.
struct Outline {
  List<Vec2> corners;

  bool contains(const Vec2& p) const {
    const Vec2* from = &corners.back();
    for (const Vec2& corner : corners) {
      if (cross(corner - *from, p - *from) < 0.0) return false;
      from = &corner;
    }
    return true;
  }
  double area() const {
    double sum = 0.0;
    const Vec2* from = &corners.back();
    for (const Vec2& corner : corners) {
      sum += 0.5 * cross(*from, corner);
      from = &corner;
    }
    return sum;
  }
  Eigen::AlignedBox2d box() const {
    Eigen::AlignedBox2d around;
    for (const Vec2& corner : corners) around.extend(corner);
    return around;
  }
};

/// Places all over a square of 1, evenly spread (R2 sequence).
std::vector<Vec2> spreadPlaces(std::size_t count) {
  constexpr double kStepX = 0.7548776662466927, kStepY = 0.5698402909980532;
  std::vector<Vec2> places;
  for (std::size_t k = 1; k <= count; ++k) {
    const auto along = static_cast<double>(k);
    places.push_back({std::fmod(kStepX * along, 1.0) - 0.5, std::fmod(kStepY * along, 1.0) - 0.5});
  }
  return places;
}

/// Places all over the outline.
List<Vec2> placesIn(const Outline& outline) {
  constexpr std::size_t kMostTimes = 10;
  static const std::vector<Vec2> kSpread = spreadPlaces(kMostTimes * kPlaces);
  const Eigen::AlignedBox2d box = outline.box();
  const double times = std::clamp(box.volume() / outline.area(), 1.0, static_cast<double>(kMostTimes));
  const auto draws = static_cast<std::size_t>(kPlaces * times);
  List<Vec2> places;
  for (std::size_t k = 0; k < draws; ++k) {
    const Vec2 place = box.center() + kSpread[k].cwiseProduct(box.sizes());
    if (outline.contains(place)) places.push_back(place);
  }
  return places;
}

/// The plane in two coordinates in which its points are equally dense.
struct FlatView {
  const Plane& plane;
  const Extent& extent;
  Density density;

  Vec2 operator()(const Vec3& p) const {
    // The image is upside down: counter-clockwise stays so.
    if (density == Density::of_pixels) return {p.x() / p.z(), -p.y() / p.z()};
    return (extent.rotation.transpose() * (p - extent.origin)).head<2>();
  }
  /// Of the plane to a piece around here, up to a factor.
  double area(const Vec2& place) const {
    if (density != Density::of_pixels) return 1.0;
    const double depth = plane.normal.dot(plane.point) / plane.normal.dot(Vec3(place.x(), -place.y(), 1.0));
    return depth * depth * depth;
  }
};

/// Some of so many points, one at random of each equal part of them. In steps that never change, or change evenly, they
/// would lie in columns of images of many widths: a wall of 512 x 512 pixels was covered to .6 then.
List<std::size_t> scattered(std::size_t all) {
  static const std::vector<double> kWithin = [] {
    Random random(1);
    std::vector<double> within;
    for (std::size_t k = 0; k < kMostInliers; ++k) within.push_back(random.uniform());
    return within;
  }();
  const std::size_t count = std::min(all, kMostInliers);
  List<std::size_t> some;
  for (std::size_t k = 0; k < count; ++k) {
    const double place = (static_cast<double>(k) + kWithin[k]) * static_cast<double>(all) / static_cast<double>(count);
    some.push_back(std::min(static_cast<std::size_t>(place), all - 1));
  }
  return some;
}

double coverageOf(const Plane& plane, const Extent& extent, const SeenPoints& inliers, Density density) {
  const FlatView flat = {plane, extent, density};
  const auto raised = [](const Vec2& p) {
    return Eigen::Vector3f(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f);
  };
  if (extent.hull.empty()) return 1.0;
  Outline outline;
  for (const Vec3& corner : extent.hull) outline.corners.push_back(flat(corner));
  // A line of points has no holes that could be told from its spacing.
  if (!(outline.area() > 1e-6 * outline.box().sizes().squaredNorm())) return 1.0;
  const List<std::size_t> some = scattered(inliers.size());
  WeightedPlaces points, possible;
  for (const std::size_t k : some) points.add(raised(flat(inliers.point(k))), 1.0f);
  points.fillUp();
  const List<Vec2> places = placesIn(outline);
  for (const Vec2& place : places) possible.add(raised(place), 1.0f);
  possible.fillUp();
  const auto reach =
      static_cast<float>(std::sqrt(kNeighbors * outline.area() / (M_PI * static_cast<double>(some.size()))));
  double hit = 0.0, all = 0.0;
  for (std::size_t k = 0; k < places.size(); k += kPlaces / kProbes) {
    const Vec2& probe = places[k];
    const double area = flat.area(probe);
    const Around found(raised(probe), reach, points);
    all += area;
    if (covered(found, Around(raised(probe), reach, possible).mean(), reach)) hit += area;
  }
  return all > 0.0 ? hit / all : 1.0;
}

/// Sum of the arcs between neighbouring angles that leave no gap.
double arcOf(List<double> angles) {
  if (angles.empty()) return 0.0;
  // Random angles leave gaps of a few mean spacings: of 60 all around the widest is 27 deg, one in ten 37.
  const double gap = std::max(15.0 * M_PI / 180.0, 12.0 * M_PI / static_cast<double>(angles.size()));
  std::sort(angles.begin(), angles.end());
  double unseen = 0.0;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const bool last = k + 1 == angles.size();
    const double step = last ? angles.front() + 2.0 * M_PI - angles.back() : angles[k + 1] - angles[k];
    if (step > gap) unseen += step;
  }
  return std::max(2.0 * M_PI - unseen, 0.0);
}

/// Around the axis of the extent, of points at least so far (m) from it.
double arcAround(const Extent& extent, const SeenPoints& inliers, double least_radius) {
  const SomePoints<kMostInliers> some(inliers);
  const Vec3 x = extent.rotation.col(0), y = extent.rotation.col(1), offset = some.origin - extent.origin;
  List<double> angles;
  angles.reserve(some.count);
  for (std::size_t k = 0; k < some.count; ++k) {
    const Vec3 place = offset + Vec3(some.x[k], some.y[k], some.z[k]);
    const Vec2 across(x.dot(place), y.dot(place));
    if (across.norm() >= least_radius) angles.push_back(std::atan2(across.y(), across.x()));
  }
  return arcOf(std::move(angles));
}

double coverageOf(const Cylinder& cylinder, const Extent& extent, const SeenPoints& inliers, Density) {
  return observedArc(cylinder, extent, inliers) / (2.0 * M_PI);
}
double coverageOf(const Cone& cone, const Extent& extent, const SeenPoints& inliers, Density) {
  return observedArc(cone, extent, inliers) / (2.0 * M_PI);
}

}  // namespace

double observedArc(const Shape& shape, const Extent& extent, const SeenPoints& inliers) {
  constexpr double kNearApex = 0.3;  // of the radius at the wide end: a tenth of a pointed cone's surface
  switch (kindOf(shape)) {
    case Kind::cylinder:
      return arcAround(extent, inliers, 0.0);
    case Kind::cone:
      return arcAround(extent, inliers, kNearApex * extent.radius);
    case Kind::plane:
    case Kind::sphere:
      break;
  }
  return 2.0 * M_PI;
}

float measureCoverage(const Shape& shape, const Extent& extent, const SeenPoints& inliers, Density density) {
  if (inliers.empty()) return 0.0f;
  const double share = std::visit([&](const auto& s) { return coverageOf(s, extent, inliers, density); }, shape);
  return static_cast<float>(std::clamp(share, 0.0, 1.0));
}

}  // namespace primitect
