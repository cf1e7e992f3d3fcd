// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering labelled points, and the last least squares; see dense_fit.h.
#include "core/dense_fit.h"

#include <cmath>
#include <optional>

#include "core/fitting.h"
#include "core/label_runs.h"
#include "core/tapered.h"

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
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) starts.push_back(tapered(*cylinder, points));
  if (const Cone* cone = std::get_if<Cone>(&shape)) {
    if (const auto cylinder = straightened(*cone, points.middle())) starts.push_back(*cylinder);
  }
  Shape best = shape;
  double most = -1.0;
  for (const Shape& start : starts) {
    const std::optional<Shape> fitted = refine(start, points);
    if (!fitted || !limits.hold(*fitted)) continue;
    const double price = kindOf(*fitted) == Kind::cone ? kConePrice * static_cast<double>(points.size()) : 0.0;
    const double agreed = agreement(*fitted, points) - price;
    if (!(agreed > most)) continue;
    best = *fitted;
    most = agreed;
  }
  return best;
}

}  // namespace primitect
