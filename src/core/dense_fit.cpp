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
constexpr double kConePrice = 0.003;

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

/// Cones that touch the cylinder along the line that the points lie around and curve as it does there, slightly tapered
/// either way: where the search for a cone on its points begins. About its own axis they would lie askew to all that
/// was seen.
List<Shape> tapered(const Cylinder& cylinder, const Vec3& middle) {
  constexpr double kTaper = 0.1;  // rad
  const Vec3 foot = cylinder.point + (middle - cylinder.point).dot(cylinder.axis) * cylinder.axis;
  const Vec3 outward = normalAt(cylinder, middle), seen = foot + cylinder.radius * outward;
  List<Shape> cones;
  for (const double way : {-1.0, 1.0}) {
    const Vec3 opening = way * cylinder.axis, apex = seen - cylinder.radius / std::tan(kTaper) * opening;
    cones.push_back(Cone{apex, std::cos(kTaper) * opening - std::sin(kTaper) * outward, kTaper});
  }
  return cones;
}

/// The cylinder that touches a cone along the line that its points lie around; nothing for points at the apex.
std::optional<Shape> straightened(const Cone& cone, const Vec3& middle) {
  constexpr double kLeast = 1e-6;  // m
  const Vec3 outward = normalAt(cone, middle);
  const Vec3 point = middle - distance(cone, middle) * outward;
  if (!((point - cone.apex).norm() > kLeast)) return std::nullopt;
  const Vec3 along = (point - cone.apex).normalized();
  const double radius = (point - cone.apex).norm() * std::tan(cone.half_angle);
  return Cylinder{point - radius * outward, along, radius};
}

}  // namespace

Shape refineOnPoints(const Shape& shape, const FitPoints& points, const Limits& limits) {
  List<Shape> starts = {shape};
  const Vec3 middle = points.middle();
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    for (const Shape& cone : tapered(*cylinder, middle)) starts.push_back(cone);
  }
  if (const Cone* cone = std::get_if<Cone>(&shape)) {
    if (const auto cylinder = straightened(*cone, middle)) starts.push_back(*cylinder);
  }
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
