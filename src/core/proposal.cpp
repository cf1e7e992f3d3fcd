// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering, fitting and growing; see proposal.h.
#include "core/proposal.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/flat.h"
#include "core/segmentation.h"
#include "core/selection.h"

namespace primitect {

namespace {

/// A plane goes through its reference: only its direction is rough.
double widenFor(const Candidate& candidate, const ProposalRules& rules) {
  return kindOf(candidate.shape) == Kind::plane ? 1.0 : rules.widen;
}

void describe(const Candidate& candidate, Hypothesis& hypothesis) {
  hypothesis.shape = candidate.shape;
  hypothesis.concave = candidate.concave;
  hypothesis.votes = candidate.votes;
}

/// How far from its reference a candidate's samples are gathered (m): in depth frames so far that a ball or a tube of
/// its radius would be seen to curve (curvature.h).
double reachFor(const Candidate& candidate, const ProposalRules& rules) {
  constexpr double kArc = 0.8;  // of the radius
  if (!rules.noise.ofDepthCamera()) return rules.reach;
  return std::max(rules.reach, kArc * radiusOf(candidate.shape).value_or(0.0));
}

/// As far as the other side of its thing (m).
double reachAcross(const Candidate& candidate, const ProposalRules& rules) {
  const Cone* cone = std::get_if<Cone>(&candidate.shape);
  const double of_cone = cone ? cone->axis.cross(candidate.point - cone->apex).norm() : 0.0;
  return std::max(rules.reach, 2.0 * radiusOf(candidate.shape).value_or(of_cone));
}

/// Gains of samples for one shape, of so many at once as soon as one of them is asked for: neighbours are asked for
/// next, and together they take hardly longer than two of them alone.
struct KnownGains {
  static constexpr std::size_t kAtOnce = kernels::kMostGains;
  List<float> gain;  ///< of each sample
  List<char> known;  ///< of each kAtOnce of them

  void begin(std::size_t samples) {
    gain.resize(samples);
    known.assign(samples / kAtOnce + 1, 0);
  }
};

/// What gather() asks of all samples, for one.
class MayStandFor {
 public:
  /// gains: begun for this candidate; within this reach (m) of its reference.
  MayStandFor(const Samples& samples, const Candidate& candidate, const ProposalRules& rules, double reach,
              KnownGains& gains)
      : gains_(gains),
        judged_(samples.judged()),
        shape_(flattened(candidate.shape, Vec3::Zero())),
        side_(candidate.concave ? -1.0f : 1.0f),
        scale_(static_cast<float>(1.0 / widenFor(candidate, rules))),
        point_(candidate.point.cast<float>()),
        reach_(static_cast<float>(reach)) {}

  bool operator()(std::uint32_t i) const {
    const Eigen::Vector3f way = Eigen::Vector3f(judged_.x[i], judged_.y[i], judged_.z[i]) - point_;
    if (!(way.squaredNorm() <= reach_ * reach_)) return false;
    if (!gains_.known[i / KnownGains::kAtOnce]) judge(i / KnownGains::kAtOnce);
    return gains_.gain[i] > 0.0f;
  }

 private:
  void judge(std::size_t part) const {
    const std::size_t begin = part * KnownGains::kAtOnce;
    const std::size_t end = std::min(begin + KnownGains::kAtOnce, gains_.gain.size());
    kernels::loops().gains(shape_, side_, scale_, judged_, begin, end, gains_.gain.data() + begin);
    gains_.known[part] = 1;
  }

  KnownGains& gains_;
  kernels::JudgedSamples judged_;
  kernels::FlatShape shape_;
  float side_, scale_;
  Eigen::Vector3f point_;
  float reach_;
};

}  // namespace

void gather(const Samples& samples, const HeldGains& held, const Candidate& candidate, const ProposalRules& rules,
            Hypothesis& hypothesis, List<std::uint32_t>& set) {
  describe(candidate, hypothesis);
  inliersAround(candidate.point, rules.reach, samples, held, widenFor(candidate, rules), hypothesis, set);
}

namespace {

/// What comes of a candidate.
enum class Outcome { nothing, known, grown };

/// Fits the hypothesis to the set, and to all that it then explains if that is more, or until it is one of the pool.
Outcome grow(const Samples& samples, const HeldGains& held, const ProposalRules& rules, List<std::uint32_t> set,
             const List<Hypothesis>& pool, Hypothesis& hypothesis, Refusals& refusals) {
  // With a third one no more is found on 60 tables; of 70 cones of the paper's scenes one more is right.
  const int growths = rules.noise.ofDepthCamera() ? 2 : 3;
  const std::size_t needed = rules.needed();
  std::size_t before = 0;
  ProposalRules of_growth = rules;
  for (int growth = 0; growth < growths && set.size() > before + before / 20; ++growth) {
    before = set.size();
    of_growth.fitted = growth > 0;
    if (!bestOfKinds(samples, held, set, of_growth, hypothesis, &refusals)) return Outcome::nothing;
    if (isKnown(hypothesis, pool)) return Outcome::known;
    inliersOf(hypothesis, set);
    if (set.size() >= needed) continue;
    ++refusals[Refusal::few_inliers];
    return Outcome::nothing;
  }
  return Outcome::grown;
}

/// Behind a pole or a finger a can falls into parts, each of which may pass for a plane. Where votes for something
/// curved led to no such thing, and much more of it lies around than is one piece with the reference, it grows from all
/// of that.
std::optional<Hypothesis> grownAcross(const Samples& samples, SampleGraph& graph, const HeldGains& held,
                                      const Candidate& candidate, const ProposalRules& rules, KnownGains& gains,
                                      const List<Hypothesis>& pool) {
  constexpr double kMuchMore = 1.4;
  if (!rules.noise.ofDepthCamera() || kindOf(candidate.shape) == Kind::plane) return std::nullopt;
  const double reach = reachAcross(candidate, rules);
  Hypothesis hypothesis;
  List<std::uint32_t> around, piece;
  describe(candidate, hypothesis);
  inliersAround(candidate.point, reach, samples, held, widenFor(candidate, rules), hypothesis, around);
  graph.connected(candidate.sample, MayStandFor(samples, candidate, rules, reach, gains), piece);
  if (static_cast<double>(around.size()) < kMuchMore * static_cast<double>(piece.size())) return std::nullopt;
  Refusals twice;  // counted already
  const Outcome outcome = grow(samples, held, rules, std::move(around), pool, hypothesis, twice);
  if (outcome != Outcome::grown || kindOf(hypothesis.shape) == Kind::plane) return std::nullopt;
  return hypothesis;
}

/// What so many stronger candidates could not explain, a weaker one will not.
constexpr std::uint8_t kTries = 2;

}  // namespace

void Proposer::begin(HeldGains held) {
  held_ = std::move(held);
  failures_.assign(held_.size(), 0);
}

bool Proposer::wants(std::uint32_t sample) const {
  constexpr float kWell = 0.4f;
  return held_[sample] <= kWell && failures_[sample] < kTries;
}

void Proposer::propose(const Samples& samples, SampleGraph& graph, const List<Candidate>& candidates,
                       const ProposalRules& rules, List<Hypothesis>& pool, Refusals& refusals) {
  const std::size_t needed = rules.needed();
  KnownGains gains;
  const auto unexplained = [this](std::uint32_t i) { return held_[i] < kWellExplained; };
  for (const Candidate& candidate : candidates) {
    if (!wants(candidate.sample)) continue;
    Hypothesis hypothesis;
    describe(candidate, hypothesis);
    gains.begin(samples.size());
    graph.connected(candidate.sample, MayStandFor(samples, candidate, rules, reachFor(candidate, rules), gains), part_);
    if (static_cast<std::size_t>(std::count_if(part_.begin(), part_.end(), unexplained)) < needed / 2) {
      ++refusals[Refusal::few_inliers];
    } else {
      const Outcome outcome = grow(samples, held_, rules, part_, pool, hypothesis, refusals);
      if (outcome == Outcome::nothing || kindOf(hypothesis.shape) == Kind::plane) {
        if (auto across = grownAcross(samples, graph, held_, candidate, rules, gains, pool)) {
          hold(*across, held_);
          pool.push_back(std::move(*across));
          if (outcome == Outcome::nothing) continue;
        }
      }
      if (outcome != Outcome::nothing) hold(hypothesis, held_);
      if (outcome == Outcome::grown) {
        pool.push_back(std::move(hypothesis));
        continue;
      }
    }
    for (const std::uint32_t i : part_) failures_[i] = std::min<std::uint8_t>(failures_[i] + 1, kTries);
  }
}

}  // namespace primitect
