// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering labelled points, and the last least squares; see dense_fit.h.
#include "core/dense_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/fitting.h"
#include "core/flat.h"
#include "core/label_runs.h"

namespace primitect {

void pointsOfLabels(const std::vector<std::uint32_t>& labels, std::size_t count, std::size_t most,
                    List<LabelledPoints>& points) {
  points.resize(count);
  for (LabelledPoints& of_label : points) of_label.index.clear(), of_label.all = 0;
  List<LabelRun> runs;
  runs.reserve(labels.size() / kLabelsAtOnce);
  forLabelRuns(labels, [&](const LabelRun& run) {
    if (run.label > count) return;
    points[run.label - 1].all += run.end - run.begin;
    runs.push_back(run);
  });
  List<std::size_t> rest(count, 0);  // how many points are to be left out before the next one
  for (const LabelRun& run : runs) {
    LabelledPoints& of_label = points[run.label - 1];
    const std::size_t step = of_label.all / most + 1;
    std::size_t next = run.begin + rest[run.label - 1];
    for (; next < run.end; next += step) of_label.index.push_back(static_cast<std::uint32_t>(next));
    rest[run.label - 1] = next - run.end;
  }
}

namespace {

/// Share of the points that a cone must explain beyond a cylinder.
constexpr double kConePrice = 0.005;

/// Sum of 1 - (distance / tolerance)^2 over the points within the tolerance.
double fitOf(const Shape& shape, const FitPoints& points) {
  constexpr std::size_t kAtOnce = 256;
  std::array<float, kAtOnce> distance;
  const kernels::FlatShape flat = flattened(shape, points.origin());
  const kernels::FitPoints p = points.view();
  double sum = 0.0;
  for (std::size_t begin = 0; begin < p.count; begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, p.count - begin);
    kernels::loops().distances(flat, p.x + begin, p.y + begin, p.z + begin, count, distance.data());
    std::array<float, kernels::kLanes> some = {};
    for (std::size_t k = 0; k < count; ++k) {
      const float share = distance[k] * p.inverse_tolerance[begin + k];
      some[k % kernels::kLanes] += share * share < 1.0f ? 1.0f - share * share : 0.0f;
    }
    for (const float of_lane : some) sum += of_lane;
  }
  return sum;
}

/// Slightly tapered either way: where the search for a cone on a cylinder's points begins.
List<Shape> tapered(const Cylinder& cylinder, const Vec3& middle) {
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

Shape refineOnPoints(const Shape& shape, const FitPoints& points, const Limits& limits) {
  List<Shape> starts = {shape};
  const Vec3 middle = points.middle();
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    for (const Shape& cone : tapered(*cylinder, middle)) starts.push_back(cone);
  }
  if (const Cone* cone = std::get_if<Cone>(&shape)) starts.push_back(straightened(*cone, middle));
  Shape best = shape;
  double best_fit = -1.0;
  for (const Shape& start : starts) {
    const std::optional<Shape> fitted = refine(start, points);
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
