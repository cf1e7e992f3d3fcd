// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scores of one scene; see metrics.h.
#include "eval/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace primitect::eval {
namespace {

Vec3 pointAt(const Cloud& cloud, std::size_t i) { return {cloud.x[i], cloud.y[i], cloud.z[i]}; }
Vec3 normalOf(const Cloud& cloud, std::size_t i) { return {cloud.nx[i], cloud.ny[i], cloud.nz[i]}; }

/// What is known of true regions or detections while instances are looked for.
struct Regions {
  const std::vector<int>& sizes;
  std::vector<bool> correct;
  std::vector<bool> explained;  ///< in any instance

  explicit Regions(const std::vector<int>& point_counts)
      : sizes(point_counts), correct(point_counts.size()), explained(point_counts.size()) {}
};

/// Finds the wholes that two or more parts make up, each part lying to the given share within the whole and all
/// together covering that share of it. Returns how many of these wholes are not correct. common: points of (whole,
/// part).
template <typename Common>
int explainSplits(Regions& wholes, Regions& parts, Common common, double share) {
  int splits = 0;
  for (std::size_t whole = 0; whole < wholes.sizes.size(); ++whole) {
    std::vector<std::size_t> inside;
    int covered = 0;
    for (std::size_t part = 0; part < parts.sizes.size(); ++part) {
      const int points = common(whole, part);
      if (points == 0 || points < share * parts.sizes[part]) continue;
      inside.push_back(part);
      covered += points;
    }
    if (inside.size() < 2 || covered < share * wholes.sizes[whole]) continue;
    splits += wholes.correct[whole] ? 0 : 1;
    wholes.explained[whole] = true;
    for (const std::size_t part : inside) parts.explained[part] = true;
  }
  return splits;
}

int countFalse(const std::vector<bool>& flags) {
  int count = 0;
  for (const bool flag : flags) count += flag ? 0 : 1;
  return count;
}

}  // namespace

Assignment assign(const Cloud& cloud, const std::vector<Shape>& shapes, const Rules& rules) {
  if (!cloud.hasNormals()) throw std::invalid_argument("scoring: the cloud has no normals");
  const double min_cosine = std::cos(rules.max_angle_deg * std::acos(-1.0) / 180.0);
  constexpr float kFar = std::numeric_limits<float>::infinity();
  Assignment assignment{std::vector<int>(cloud.size(), -1), std::vector<float>(cloud.size(), kFar)};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const Vec3 point = pointAt(cloud, i), normal = normalOf(cloud, i);
    double closest = rules.max_distance;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      const double away = std::abs(distance(shapes[k], point));
      assignment.distance[i] = std::min(assignment.distance[i], static_cast<float>(away));
      if (!(away < closest && std::abs(normalAt(shapes[k], point).dot(normal)) >= min_cosine)) continue;
      closest = away;
      assignment.shape[i] = static_cast<int>(k);
    }
  }
  return assignment;
}

Overlaps::Overlaps(std::size_t truths, std::size_t detections)
    : true_size(truths, 0), found_size(detections, 0), common(truths, std::vector<int>(detections, 0)) {}

Overlaps countOverlaps(const std::vector<int>& truth, std::size_t truths, const std::vector<int>& found,
                       std::size_t detections) {
  if (truth.size() != found.size()) throw std::invalid_argument("scoring: truth and result differ in their points");
  Overlaps overlaps(truths, detections);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] >= 0) ++overlaps.true_size.at(truth[i]);
    if (found[i] >= 0) ++overlaps.found_size.at(found[i]);
    if (truth[i] >= 0 && found[i] >= 0) ++overlaps.common[truth[i]][found[i]];
  }
  return overlaps;
}

Segmentation segment(const Overlaps& overlaps, double overlap) {
  Segmentation result;
  Regions truths(overlaps.true_size), found(overlaps.found_size);
  for (std::size_t t = 0; t < truths.sizes.size(); ++t) {
    for (std::size_t d = 0; d < found.sizes.size(); ++d) {
      const int common = overlaps.common[t][d];
      if (common == 0 || common < overlap * truths.sizes[t] || common < overlap * found.sizes[d]) continue;
      result.correct.emplace_back(static_cast<int>(t), static_cast<int>(d));
      truths.correct[t] = truths.explained[t] = true;
      found.correct[d] = found.explained[d] = true;
    }
  }
  result.over_segmented = explainSplits(
      truths, found, [&](std::size_t t, std::size_t d) { return overlaps.common[t][d]; }, overlap);
  result.under_segmented = explainSplits(
      found, truths, [&](std::size_t d, std::size_t t) { return overlaps.common[t][d]; }, overlap);
  result.missed = countFalse(truths.explained);
  result.noise = countFalse(found.explained);
  return result;
}

double objectDistance(const Cloud& cloud, const std::vector<int>& labels, int label, const Shape& truth,
                      const Shape& found) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != label || !cloud.valid(i)) continue;
    const Vec3 point = pointAt(cloud, i);
    sum += (project(truth, point) - project(found, point)).norm();
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

double pointCoverage(const Assignment& assignment, const Cloud& cloud, double epsilon) {
  std::size_t points = 0, covered = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    ++points;
    covered += assignment.distance[i] < epsilon ? 1 : 0;
  }
  return points > 0 ? static_cast<double>(covered) / points : 0.0;
}

double shapeCoverage(const Assignment& assignment, const Cloud& cloud, const std::vector<Shape>& found,
                     double epsilon) {
  std::vector<double> points(found.size(), 0.0), covered(found.size(), 0.0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const int shape = assignment.shape[i];
    if (shape < 0) continue;
    points[shape] += 1.0;
    covered[shape] += std::abs(distance(found[shape], pointAt(cloud, i))) < epsilon ? 1.0 : 0.0;
  }
  double sum = 0.0;
  int counted = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (points[k] == 0.0) continue;
    sum += covered[k] / points[k];
    ++counted;
  }
  return counted > 0 ? sum / counted : 0.0;
}

}  // namespace primitect::eval
