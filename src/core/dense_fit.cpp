// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering labelled points, and the last least squares; see dense_fit.h.
#include "core/dense_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "core/fitting.h"

namespace primitect {

std::vector<LabelledPoints> pointsOfLabels(const std::vector<std::uint32_t>& labels, std::size_t count,
                                           std::size_t most) {
  std::vector<LabelledPoints> points(count);
  for (const std::uint32_t label : labels) {
    if (label > 0) ++points[label - 1].all;
  }
  std::vector<std::size_t> rank(count, 0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0) continue;
    const std::size_t k = labels[i] - 1;
    const std::size_t step = points[k].all / most + 1;
    if (rank[k]++ % step == 0) points[k].index.push_back(static_cast<std::uint32_t>(i));
  }
  return points;
}

Samples samplesAt(const Cloud& cloud, const std::vector<std::uint32_t>& index, const NoiseModel& noise) {
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  Samples points;
  points.index = index;
  points.resize(index.size());
  for (std::size_t k = 0; k < index.size(); ++k) {
    points.x[k] = cloud.x[index[k]], points.y[k] = cloud.y[index[k]], points.z[k] = cloud.z[index[k]];
    points.nx[k] = points.ny[k] = points.nz[k] = kMissing;
    points.normal_sigma[k] = 0.0f;
  }
  applyNoise(noise, points);
  return points;
}

namespace {

/// Share of the points that a cone must explain beyond a cylinder.
constexpr double kConePrice = 0.005;

/// Sum of 1 - (distance / tolerance)^2 over the points within the tolerance.
double fitOf(const Shape& shape, const Samples& points) {
  double sum = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double share = distance(shape, points.point(k)) / (kInlierDeviations * points.sigma[k]);
    if (std::abs(share) < 1.0) sum += 1.0 - share * share;
  }
  return sum;
}

Vec3 meanOf(const Samples& points) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) sum += points.point(k);
  return sum / static_cast<double>(points.size());
}

/// Slightly tapered either way: where the search for a cone on a cylinder's points begins.
std::vector<Shape> tapered(const Cylinder& cylinder, const Vec3& middle) {
  constexpr double kTaper = 0.1;  // rad
  const Vec3 center = cylinder.point + (middle - cylinder.point).dot(cylinder.axis) * cylinder.axis;
  const Vec3 to_apex = cylinder.radius / std::tan(kTaper) * cylinder.axis;
  return {Cone{center - to_apex, cylinder.axis, kTaper}, Cone{center + to_apex, -cylinder.axis, kTaper}};
}

/// A cone's points as those of a cylinder.
Shape straightened(const Cone& cone, const Vec3& middle) {
  const double height = (middle - cone.apex).dot(cone.axis);
  return Cylinder{cone.apex + height * cone.axis, cone.axis, height * std::tan(cone.half_angle)};
}

}  // namespace

Shape refineOnPoints(const Shape& shape, const Samples& points, const NoiseModel& noise, const Limits& limits) {
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0u);
  std::vector<Shape> starts = {shape};
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    for (const Shape& cone : tapered(*cylinder, meanOf(points))) starts.push_back(cone);
  }
  if (const Cone* cone = std::get_if<Cone>(&shape)) starts.push_back(straightened(*cone, meanOf(points)));
  Shape best = shape;
  double best_fit = -1.0;
  for (const Shape& start : starts) {
    const std::optional<Shape> fitted =
        refine(start, {points, all}, [&](const Vec3& p) { return kInlierDeviations * noise.at(p); });
    if (!fitted || !limits.hold(*fitted)) continue;
    const double price = kindOf(*fitted) == Kind::cone ? kConePrice * static_cast<double>(points.size()) : 0.0;
    const double fit = fitOf(*fitted, points) - price;
    if (!(fit > best_fit)) continue;
    best = *fitted;
    best_fit = fit;
  }
  return best;
}

}  // namespace primitect
