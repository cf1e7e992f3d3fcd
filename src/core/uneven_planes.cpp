// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes of the unexplained samples, proposed with more noise; see uneven_planes.h.
#include "core/uneven_planes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/choice.h"
#include "core/evidence.h"
#include "core/proposal.h"

namespace primitect {
namespace {

/// Of all samples, so many are on a large one.
constexpr double kLarge = 0.045;

/// Of all samples; with twice as much noise nothing can be told.
bool isPoor(const NoiseModel& noise) {
  constexpr double kPoorNormals = 0.3, kPoorDepths = 1.5;  // rad, times that of structured light
  return noise.angle > kPoorNormals || noise.scale > kPoorDepths;
}

/// More noise of distances and normals.
NoiseModel loosened(NoiseModel noise) {
  constexpr double kDistances = 2.0, kNormals = 1.5;
  noise.scale *= kDistances;
  noise.depth_share *= kDistances;
  noise.angle *= kNormals;
  noise.normals *= kNormals;
  noise.most_turn *= kNormals;
  return noise;
}

/// The plane through a sample that lies as the surface around it.
Candidate facing(const Samples& samples, const SampleGraph& graph, std::uint32_t i) {
  Vec3 normal = samples.normal(i);
  for (const std::uint32_t j : graph.of(i)) {
    if (continuous(samples, i, j)) normal += samples.normal(j);
  }
  Candidate candidate;
  candidate.sample = i;
  candidate.point = samples.point(i);
  candidate.normal = normal.normalized();
  candidate.shape = Plane{candidate.point, candidate.normal};
  return candidate;
}

/// Of what nobody explains, where much of it hangs together.
List<Candidate> candidatesOf(const Samples& samples, SampleGraph& graph, const HeldGains& held, std::size_t least) {
  constexpr std::size_t kEvery = 16;  // samples
  List<std::uint32_t> rest;
  for (std::uint32_t i = 0; i < held.size(); ++i) {
    if (!(held[i] > 0.0f)) rest.push_back(i);
  }
  List<Candidate> candidates;
  for (const List<std::uint32_t>& part : graph.parts(rest, least)) {
    for (std::size_t k = kEvery / 2; k < part.size(); k += kEvery) {
      candidates.push_back(facing(samples, graph, part[k]));
    }
  }
  return candidates;
}

/// Standard deviation (m) of these samples across their longest side.
double halfWidth(const Samples& samples, const List<std::uint32_t>& set) {
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t i : set) middle += samples.point(i);
  middle /= static_cast<double>(set.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : set) {
    const Vec3 way = samples.point(i) - middle;
    spread += way * way.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(spread / static_cast<double>(set.size()), Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[1], 0.0));
}

/// Whether more noise is all that was missing.
bool isClear(const UnevenPlane& plane, const Samples& samples) {
  constexpr double kSure = 0.9;
  constexpr double kNarrow = 0.06;                     // m: 20 cm from side to side
  constexpr double kAgainst = 0.1, kAgainstAll = 0.3;  // each sample, of a large plane and of one that is all there is
  const double share = static_cast<double>(plane.inliers.size()) / static_cast<double>(samples.size());
  return plane.confidence >= kSure && plane.evidence.against <= std::max(kAgainst, kAgainstAll * share) &&
         halfWidth(samples, plane.inliers) >= kNarrow;
}

}  // namespace

List<UnevenPlane> findUnevenPlanes(const Samples& samples, SampleGraph& graph, const HeldGains& held,
                                   List<std::uint32_t> owner, const ProposalRules& rules) {
  if (isPoor(rules.noise)) return {};
  const auto least = static_cast<std::size_t>(std::ceil(kLarge * static_cast<double>(samples.size())));
  const List<Candidate> candidates = candidatesOf(samples, graph, held, least);
  if (candidates.empty()) return {};
  // What is smaller is not even fitted.
  Params large = rules.limits.params;
  large.min_inliers = static_cast<int>(least);
  const Limits limits = {large, rules.limits.max_radius, rules.limits.min_half_angle_deg, rules.limits.min_distance};
  const ProposalRules loose = {loosened(rules.noise), limits, rules.widen,         rules.reach,
                               rules.most_fitted,     false,  rules.fitted_normals};
  Samples noisier = samples;
  applyNoise(loose.noise, noisier);
  Proposer proposer;
  proposer.begin(held);
  List<Hypothesis> pool;
  Refusals not_counted{};
  proposer.propose(noisier, graph, candidates, loose, pool, not_counted);
  std::sort(pool.begin(), pool.end(), [](const auto& a, const auto& b) { return a.gain_sum > b.gain_sum; });
  List<UnevenPlane> planes;
  for (Hypothesis& hypothesis : pool) {
    if (kindOf(hypothesis.shape) != Kind::plane || hypothesis.inliers < least) continue;
    UnevenPlane plane;
    inliersOf(hypothesis, plane.inliers);
    const auto taken = [&owner](std::uint32_t i) { return owner[i] != kNobody; };
    plane.inliers.erase(std::remove_if(plane.inliers.begin(), plane.inliers.end(), taken), plane.inliers.end());
    if (plane.inliers.size() < least) continue;
    const auto give = [&](std::uint32_t to) {
      for (const std::uint32_t i : plane.inliers) owner[i] = to;
    };
    const auto self = static_cast<std::uint32_t>(kNobody - 1 - planes.size());  // nobody else's number
    give(self);
    plane.evidence = gatherEvidence(noisier, graph, owner, self, hypothesis);
    plane.confidence = confidenceOf(Kind::plane, plane.evidence);
    if (!isClear(plane, samples)) {
      give(kNobody);
      continue;
    }
    plane.hypothesis = std::move(hypothesis);
    planes.push_back(std::move(plane));
  }
  return planes;
}

}  // namespace primitect
