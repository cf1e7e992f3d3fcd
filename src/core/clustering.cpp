// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Greedy clustering, strongest candidate first, and the averages of shapes.
#include "core/clustering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace primitect {

void sortByVotes(List<Candidate>& candidates) {
  // Not std::stable_sort, which takes memory from the heap.
  List<std::pair<double, std::size_t>> order;
  order.reserve(candidates.size());
  for (std::size_t k = 0; k < candidates.size(); ++k) order.emplace_back(-candidates[k].votes, k);
  std::sort(order.begin(), order.end());
  List<Candidate> sorted;
  sorted.reserve(candidates.size());
  for (const auto& [votes, k] : order) sorted.push_back(candidates[k]);
  candidates.swap(sorted);
}

namespace {

/// All four kinds are a point, a direction and a number, and are averaged in these.
struct Parts {
  Vec3 point, direction;
  double number;
};

Parts partsOf(const Plane& plane) { return {plane.point, plane.normal, 0.0}; }
Parts partsOf(const Sphere& sphere) { return {sphere.center, Vec3::UnitZ(), sphere.radius}; }
Parts partsOf(const Cylinder& cylinder) { return {cylinder.point, cylinder.axis, cylinder.radius}; }
Parts partsOf(const Cone& cone) { return {cone.apex, cone.axis, cone.half_angle}; }
Parts partsOf(const Shape& shape) {
  return std::visit([](const auto& s) { return partsOf(s); }, shape);
}

Shape shapeOf(Kind kind, const Parts& parts) {
  switch (kind) {
    case Kind::plane:
      return Plane{parts.point, parts.direction};
    case Kind::sphere:
      return Sphere{parts.point, parts.number};
    case Kind::cylinder:
      return Cylinder{parts.point, parts.direction, parts.number};
    case Kind::cone:
      break;
  }
  return Cone{parts.point, parts.direction, parts.number};
}

/// Candidates that agree with their strongest one, and the weighted sums of their parts.
struct Cluster {
  Candidate strongest;
  Parts sum;
  double votes;
  int proposals;

  explicit Cluster(const Candidate& candidate)
      : strongest(candidate), sum{Vec3::Zero(), Vec3::Zero(), 0.0}, votes(0.0), proposals(0) {
    add(candidate);
  }

  void add(const Candidate& candidate) {
    const Parts parts = partsOf(candidate.shape);
    // Only the cylinder's axis has no sign; of the others an opposite direction never gets here.
    const bool opposite = parts.direction.dot(partsOf(strongest.shape).direction) < 0.0;
    sum.point += candidate.votes * parts.point;
    sum.direction += (opposite ? -candidate.votes : candidate.votes) * parts.direction;
    sum.number += candidate.votes * parts.number;
    votes += candidate.votes;
    proposals += candidate.proposals;
  }

  Candidate best() const {
    Candidate result = strongest;
    result.votes = votes;
    result.proposals = proposals;
    return result;
  }

  Candidate average() const {
    const Parts mean = {sum.point / votes, sum.direction.normalized(), sum.number / votes};
    Candidate result = best();
    result.shape = shapeOf(kindOf(strongest.shape), mean);
    return result;
  }
};

void clusterOnce(List<Candidate>& candidates, double distance, double angle, bool average) {
  sortByVotes(candidates);
  List<Cluster> clusters;
  for (const Candidate& candidate : candidates) {
    const auto home = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
      return agrees(candidate, cluster.strongest, distance, angle);
    });
    if (home == clusters.end()) {
      clusters.emplace_back(candidate);
    } else {
      home->add(candidate);
    }
  }
  candidates.clear();
  for (const Cluster& cluster : clusters) candidates.push_back(average ? cluster.average() : cluster.best());
  sortByVotes(candidates);
}

}  // namespace

bool agrees(const Candidate& candidate, const Candidate& other, double max_distance, double max_angle) {
  if (candidate.shape.index() != other.shape.index() || candidate.concave != other.concave) return false;
  if (!(std::abs(distance(other.shape, candidate.point)) < max_distance)) return false;
  return candidate.normal.dot(seenNormalAt(other.shape, other.concave, candidate.point)) > std::cos(max_angle);
}

void clusterCandidates(List<Candidate>& candidates, const Params& params, double scene_diameter) {
  const double distance = params.cluster_distance * scene_diameter;
  const double angle = params.cluster_angle_deg * M_PI / 180.0;
  const bool average = params.clustering == "average";
  clusterOnce(candidates, distance, angle, average);
  // Averages of neighbouring clusters come to agree where their strongest members did not.
  if (average) clusterOnce(candidates, distance, angle, average);
}

}  // namespace primitect
