// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes of the unexplained samples, proposed with more noise; see uneven_planes.h.
#include "core/uneven_planes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/choice.h"
#include "core/evidence.h"
#include "core/fitting.h"
#include "core/proposal.h"

namespace primitect {
namespace {

/// Of all samples, or with twice as much noise nothing can be told. Depths: 1.5 is what is tolerated in images with 2.1
/// times the noise of structured light (toleratedScale()).
bool isPoor(const NoiseModel& noise) {
  constexpr double kPoorNormals = 0.3, kPoorDepths = 1.5;  // rad; times the noise of structured light
  return noise.angle > kPoorNormals || noise.scale > kPoorDepths;
}

/// Samples of a large plane, of all draws. With half as many, of what comes out in 300 frames of that simulator as much
/// is wrong (insides of buckets, cloths) as right.
std::size_t leastOf(const Samples& samples, const ProposalRules& rules) {
  constexpr double kOfAll = 0.045;
  constexpr std::size_t kFewest = 100;
  const double share = std::ceil(kOfAll * static_cast<double>(samples.size()));
  return std::max({rules.needed(), kFewest, static_cast<std::size_t>(share)});
}

/// More noise of distances and normals: of the samples of walls that were missing there, which stray by 1.6 to 2.4
/// standard deviations.
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
  List<Candidate> candidates;
  for (const List<std::uint32_t>& part : graph.parts(notHeld(held), least)) {
    for (std::size_t k = kEvery / 2; k < part.size(); k += kEvery) {
      candidates.push_back(facing(samples, graph, part[k]));
    }
  }
  return candidates;
}

/// The same samples with another noise; the first draw stays apart from later ones.
Samples withNoise(const NoiseModel& noise, const Samples& samples) {
  Samples result;
  for (const bool first : {true, false}) {
    const std::size_t begin = first ? 0 : samples.first_draw, end = first ? samples.first_draw : samples.size();
    List<std::uint32_t> draw(end - begin);
    std::iota(draw.begin(), draw.end(), static_cast<std::uint32_t>(begin));
    Samples part = samples.part(draw);
    applyNoise(noise, part);
    result.append(part);
  }
  return result;
}

/// Standard deviation (m) across the longest side of what has these moments.
double deviationAcross(const Moments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.points, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[1], 0.0));
}

/// Whether more noise is all that was missing.
bool isClear(const UnevenPlane& plane, const Samples& samples) {
  constexpr double kSure = 0.9;
  constexpr double kNarrow = 0.06;                     // m: 20 cm from side to side
  constexpr double kAgainst = 0.1, kAgainstAll = 0.3;  // each sample, of a large plane and of one that is all there is
  const double share = static_cast<double>(plane.inliers.size()) / static_cast<double>(samples.size());
  if (confidenceOf(Kind::plane, plane.evidence) < kSure ||
      plane.evidence.against > std::max(kAgainst, kAgainstAll * share))
    return false;
  FitPoints points;
  points.gather({samples, plane.inliers});
  return deviationAcross(momentsOf(points)) >= kNarrow;
}

/// Those of its inliers that nobody has, where at least `least` of them hang together.
List<std::uint32_t> freeInliers(const Hypothesis& hypothesis, const List<std::uint32_t>& owner, SampleGraph& graph,
                                std::size_t least) {
  List<std::uint32_t> inliers;
  inliersOf(hypothesis, inliers);
  const auto taken = [&owner](std::uint32_t i) { return owner[i] != kNobody; };
  inliers.erase(std::remove_if(inliers.begin(), inliers.end(), taken), inliers.end());
  return graph.largeParts(inliers, least);
}

void give(const List<std::uint32_t>& samples, std::uint32_t to, List<std::uint32_t>& owner) {
  for (const std::uint32_t i : samples) owner[i] = to;
}

/// What comes of the candidates with these rules, what explains most first.
List<Hypothesis> proposed(const Samples& samples, SampleGraph& graph, const HeldGains& held,
                          const List<Candidate>& candidates, const ProposalRules& rules) {
  Proposer proposer;
  proposer.begin(held);
  List<Hypothesis> pool;
  Refusals not_counted{};
  proposer.propose(samples, graph, candidates, rules, pool, not_counted);
  std::sort(pool.begin(), pool.end(), [](const auto& a, const auto& b) { return a.gain_sum > b.gain_sum; });
  return pool;
}

}  // namespace

List<UnevenPlane> findUnevenPlanes(const Samples& samples, SampleGraph& graph, const HeldGains& held,
                                   List<std::uint32_t> owner, const ProposalRules& rules) {
  if (isPoor(rules.noise)) return {};
  const std::size_t least = leastOf(samples, rules);
  const List<Candidate> candidates = candidatesOf(samples, graph, held, least);
  if (candidates.empty()) return {};
  ProposalRules loose = rules;
  loose.noise = loosened(rules.noise);
  // What has less than half of it at first will not grow to it.
  loose.least = least / 2;
  const Samples noisier = withNoise(loose.noise, samples);
  List<UnevenPlane> planes;
  for (const Hypothesis& hypothesis : proposed(noisier, graph, held, candidates, loose)) {
    if (kindOf(hypothesis.shape) != Kind::plane) continue;
    UnevenPlane plane = {std::get<Plane>(hypothesis.shape), freeInliers(hypothesis, owner, graph, rules.needed())};
    if (plane.inliers.size() < least) continue;
    const auto self = static_cast<std::uint32_t>(kNobody - 1 - planes.size());  // nobody else's number
    give(plane.inliers, self, owner);
    plane.evidence = gatherEvidence(noisier, graph, owner, self, hypothesis);
    if (isClear(plane, samples)) {
      planes.push_back(std::move(plane));
    } else {
      give(plane.inliers, kNobody, owner);
    }
  }
  return planes;
}

}  // namespace primitect
