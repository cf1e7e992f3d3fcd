// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Fits of all kinds and their scores; see competition.h.
#include "core/competition.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curvature.h"
#include "core/fitting.h"
#include "core/segmentation.h"
#include "core/tapered.h"

namespace primitect {
namespace {

double radiusOf(const Shape& shape) {
  if (const Sphere* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  const Cylinder* cylinder = std::get_if<Cylinder>(&shape);
  return cylinder ? cylinder->radius : 0.0;
}

bool enabled(Kind kind, const Params& params) {
  const bool switches[] = {params.detect_planes, params.detect_spheres, params.detect_cylinders, params.detect_cones};
  return switches[static_cast<std::size_t>(kind)];
}

/// A tube so thin that the edge of a table, rounded by a depth camera, looks the same.
bool tooThin(const Shape& shape, double sigma, const NoiseModel& noise) {
  constexpr double kLeastRadius = 6.5;  // standard deviations of the noise
  const Cylinder* tube = std::get_if<Cylinder>(&shape);
  return noise.depth_share > 0.0 && tube && tube->radius < kLeastRadius * sigma;
}

/// Where a fit begins.
struct Start {
  Shape shape;
  bool concave;
};

/// The hypothesis itself, a plane, and every curved kind on every side that is wanted.
List<Start> startsFor(const Hypothesis& hypothesis, const Moments& moments, double sigma, const ProposalRules& rules) {
  const Params& params = rules.limits.params;
  const bool curved = curvesEnough(moments, sigma, rules.noise);
  List<Start> starts;
  const auto add = [&](const std::optional<Shape>& shape, bool concave) {
    if (!shape || !enabled(kindOf(*shape), params)) return;
    if (curved || kindOf(*shape) == Kind::plane) starts.push_back({*shape, concave});
  };
  add(hypothesis.shape, hypothesis.concave);
  // From anywhere near, there is only one plane to come to.
  if (starts.empty() || kindOf(starts[0].shape) != Kind::plane) add(fitFromMoments(Kind::plane, moments), false);
  for (const bool concave : {false, true}) {
    if (!curved) break;
    if (params.convexity == (concave ? "convex" : "concave")) continue;
    for (const Kind kind : {Kind::sphere, Kind::cylinder, Kind::cone}) {
      if (kind == kindOf(hypothesis.shape) && concave == hypothesis.concave) continue;
      add(fitFromMoments(kind, concave ? flipped(moments) : moments), concave);
    }
  }
  return starts;
}

/// How far the farthest of the set is from there (m).
double reachOf(const Samples& samples, const List<std::uint32_t>& set, const Vec3& middle) {
  double farthest_sq = 0.0;
  for (const std::uint32_t i : set) farthest_sq = std::max(farthest_sq, (samples.point(i) - middle).squaredNorm());
  return std::sqrt(farthest_sq);
}

/// Where a shape ends, in times the distance of the farthest sample that it was fitted to. Measured: against no bound,
/// 1 finds 0.6 % more of the shapes on tables and 2 % more among outliers, but outside of depth frames one cylinder in
/// two hundred falls apart and 1 % of the cones go wrong; 2.5 does neither.
double beyond(const NoiseModel& noise) {
  constexpr double kOfDepth = 1.0, kOfOthers = 2.5;
  return noise.depth_share > 0.0 ? kOfDepth : kOfOthers;
}

/// The plane that lies as its samples' normals say, where the one through its samples does not: those of a narrow strip
/// tell little about how it lies across, and beside an edge many samples have no good normal and are not taken.
std::optional<Plane> planeByNormals(const Plane& fitted, const Moments& moments, double sigma) {
  constexpr double kAskew = 0.05;  // rad
  constexpr double kNarrow = 3.5;  // standard deviations of the noise, across the strip
  constexpr double kAgreed = 0.9;  // length of the mean normal: normals to both sides would cancel
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.points, Eigen::EigenvaluesOnly);
  if (!(solver.eigenvalues()[1] < kNarrow * kNarrow * sigma * sigma)) return std::nullopt;
  if (!(moments.mean_normal.norm() > kAgreed)) return std::nullopt;
  const Vec3 normal = moments.mean_normal.normalized();
  if (!(normal.cross(fitted.normal).norm() > kAskew)) return std::nullopt;
  return Plane{moments.mean_point, normal};
}

/// Calls use(trial) with the fit from each start that ends within the limits, and its score; counts those that do not.
template <class Use>
int fitAll(const Samples& samples, const HeldGains& held, const List<std::uint32_t>& set, const ProposalRules& rules,
           const Hypothesis& hypothesis, const Use& use) {
  FitPoints points;
  points.gather({samples, set});
  // First with the tolerance that gathered the samples, so that a poor start is not left where it is; to a step far
  // below what few samples can tell.
  constexpr double kSmallStep = 0.02;  // of the noise
  const RefineRules refine_rules = {rules.widen, 2, 6, kSmallStep / kInlierDeviations};
  int refused = 0;
  Hypothesis trial;
  trial.middle = points.middle();
  trial.reach = beyond(rules.noise) * reachOf(samples, set, trial.middle);
  const Moments moments = momentsOf(points);
  const auto judge = [&](const Shape& shape, bool concave) {
    trial.shape = shape;
    trial.concave = concave;
    score(samples, held, 1.0, trial);
    use(trial);
  };
  std::optional<Start> cylinder;  // the best one
  double most = 0.0;
  const auto fit = [&](const Start& start) {
    const std::optional<Shape> shape = refine(start.shape, points, refine_rules);
    if (!shape) return;
    if (!rules.limits.hold(*shape) || tooThin(*shape, points.meanSigma(), rules.noise)) {
      ++refused;
      return;
    }
    judge(*shape, start.concave);
    if (kindOf(*shape) == Kind::cylinder && trial.score > most) {
      cylinder = {*shape, start.concave};
      most = trial.score;
    }
    if (const Plane* plane = std::get_if<Plane>(&*shape)) {
      if (const auto by_normals = planeByNormals(*plane, moments, points.meanSigma()))
        judge(*by_normals, start.concave);
    }
  };
  for (const Start& start : startsFor(hypothesis, moments, points.meanSigma(), rules)) fit(start);
  if (cylinder && enabled(Kind::cone, rules.limits.params)) {
    fit({tapered(std::get<Cylinder>(cylinder->shape), points), cylinder->concave});
  }
  return refused;
}

}  // namespace

bool Limits::hold(const Shape& shape) const {
  return enabled(kindOf(shape), params) && withinLimits(shape, params) && radiusOf(shape) <= max_radius;
}

bool bestOfKinds(const Samples& samples, const HeldGains& held, const List<std::uint32_t>& set,
                 const ProposalRules& rules, Hypothesis& hypothesis, Refusals* refusals) {
  double best = 0.0;
  const int refused = fitAll(samples, held, set, rules, hypothesis, [&](const Hypothesis& trial) {
    if (!(trial.score > best)) return;
    best = trial.score;
    hypothesis.shape = trial.shape;
    hypothesis.concave = trial.concave;
    hypothesis.middle = trial.middle;
    hypothesis.reach = trial.reach;
  });
  if (refusals) (*refusals)[Refusal::limits] += refused;
  if (best > 0.0) evaluate(samples, held, 1.0, hypothesis);
  return best > 0.0;
}

Rival bestRival(const Samples& samples, const HeldGains& held, const List<std::uint32_t>& set,
                const ProposalRules& rules, const Hypothesis& hypothesis) {
  constexpr double kClose = 0.05;
  Rival rival;
  Hypothesis own;
  own.shape = hypothesis.shape;
  own.concave = hypothesis.concave;
  own.middle = hypothesis.middle;
  own.reach = beyond(rules.noise) * reachOf(samples, set, own.middle);  // as for its rivals
  score(samples, held, 1.0, own);
  double best = 0.0;
  fitAll(samples, held, set, rules, hypothesis, [&](const Hypothesis& trial) {
    if (kindOf(trial.shape) == kindOf(hypothesis.shape) || !(trial.score > best)) return;
    best = trial.score;
    rival.kind = kindOf(trial.shape);
  });
  rival.lead = (own.score - best) / static_cast<double>(set.size());
  if (rival.lead > kClose) rival.kind.reset();
  return rival;
}

}  // namespace primitect
