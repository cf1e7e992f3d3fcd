// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures on points; see metrics.h.
#include "eval/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace primitect::eval {
namespace {

/// Adds 1 for every epsilon above the distance.
void countBelow(float distance, const std::vector<double>& epsilons, std::vector<double>& counts) {
  const auto first = std::upper_bound(epsilons.begin(), epsilons.end(), static_cast<double>(distance));
  for (std::size_t k = first - epsilons.begin(); k < epsilons.size(); ++k) counts[k] += 1.0;
}

}  // namespace

std::vector<int> assign(const Cloud& cloud, const std::vector<Shape>& shapes, const Rules& rules) {
  if (!cloud.hasNormals()) throw std::invalid_argument("scoring: the cloud has no normals");
  if (!(rules.max_distance > 0.0 && rules.max_angle_deg >= 0.0 && rules.max_angle_deg <= 90.0)) {
    throw std::invalid_argument("scoring: max_distance must be above 0 m, max_angle_deg in 0 to 90");
  }
  const double min_cosine = std::cos(rules.max_angle_deg * std::acos(-1.0) / 180.0);
  std::vector<int> labels(cloud.size(), -1);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const Vec3 point = cloud.point(i), normal = cloud.normal(i);
    double closest = rules.max_distance;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      const double away = std::abs(distance(shapes[k], point));
      if (!(away < closest && std::abs(normalAt(shapes[k], point).dot(normal)) >= min_cosine)) continue;
      closest = away;
      labels[i] = static_cast<int>(k);
    }
  }
  return labels;
}

Distances measureDistances(const Cloud& cloud, const std::vector<Shape>& shapes, const std::vector<int>& labels) {
  if (labels.size() != cloud.size()) throw std::invalid_argument("scoring: labels and points differ in number");
  const std::vector<float> unknown(cloud.size(), std::numeric_limits<float>::quiet_NaN());
  Distances distances{unknown, unknown};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const Vec3 point = cloud.point(i);
    double closest = std::numeric_limits<double>::infinity();
    for (const Shape& shape : shapes) closest = std::min(closest, std::abs(distance(shape, point)));
    distances.closest[i] = static_cast<float>(closest);
    if (labels[i] >= 0) distances.own[i] = static_cast<float>(std::abs(distance(shapes.at(labels[i]), point)));
  }
  return distances;
}

double objectDistance(const Cloud& cloud, const std::vector<int>& labels, int label, const Shape& truth,
                      const Shape& found) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != label || !cloud.valid(i)) continue;
    const Vec3 point = cloud.point(i);
    sum += (project(truth, point) - project(found, point)).norm();
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

std::vector<double> pointCoverage(const Distances& distances, const std::vector<double>& epsilons) {
  std::vector<double> covered(epsilons.size(), 0.0);
  double points = 0.0;
  for (const float away : distances.closest) {
    if (std::isnan(away)) continue;
    points += 1.0;
    countBelow(away, epsilons, covered);
  }
  for (double& count : covered) count = points > 0.0 ? count / points : 0.0;
  return covered;
}

std::vector<double> shapeCoverage(const Distances& distances, const std::vector<int>& labels, std::size_t detections,
                                  const std::vector<double>& epsilons) {
  std::vector<double> points(detections, 0.0);
  std::vector<std::vector<double>> covered(detections, std::vector<double>(epsilons.size(), 0.0));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (std::isnan(distances.own[i])) continue;
    points.at(labels[i]) += 1.0;
    countBelow(distances.own[i], epsilons, covered[labels[i]]);
  }
  const auto seen = std::count_if(points.begin(), points.end(), [](double count) { return count > 0.0; });
  if (seen == 0) return {};
  std::vector<double> mean(epsilons.size(), 0.0);
  for (std::size_t d = 0; d < detections; ++d) {
    for (std::size_t k = 0; k < epsilons.size() && points[d] > 0.0; ++k) mean[k] += covered[d][k] / points[d] / seen;
  }
  return mean;
}

}  // namespace primitect::eval
