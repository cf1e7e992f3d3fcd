// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A line with a step, and one with a bend, fitted to the distances along the axis; see axis_steps.h.
#include "core/axis_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/axis_extent.h"

namespace primitect {
namespace {

/// The axis is cut between two of these.
constexpr std::size_t kSlices = 32;

/// Sums over samples of 1, t, t^2, t^3, t^4, d, t d and t^2 d, with t the place along the axis from -1 to 1 and d the
/// distance from the shape.
struct Sums {
  double count = 0.0, t = 0.0, tt = 0.0, ttt = 0.0, tttt = 0.0, d = 0.0, td = 0.0, ttd = 0.0;

  void add(double place, double distance) {
    const double square = place * place;
    count += 1.0;
    t += place, tt += square, ttt += square * place, tttt += square * square;
    d += distance, td += place * distance, ttd += square * distance;
  }
  void add(const Sums& more) {
    count += more.count;
    t += more.t, tt += more.tt, ttt += more.ttt, tttt += more.tttt;
    d += more.d, td += more.td, ttd += more.ttd;
  }
};

/// Something in the distances beside what a line along the axis explains: a step, or a bend.
struct Term {
  double height = 0.0;    ///< as the distances
  double evidence = 0.0;  ///< sum of the squares that it explains
};

/// Sums over a term's values f: of f, f^2, t f and f d.
struct TermSums {
  double f, ff, tf, fd;
};

/// Least squares in two stages (Frisch and Waugh 1933): what the line explains of term and distances goes first.
Term besideLine(const TermSums& term, const Sums& all) {
  constexpr double kLeastOwn = 1e-9;  // of the samples: the line is the term
  const double n = all.count, middle = all.t / n, spread = all.tt - n * middle * middle;
  if (!(spread > 0.0)) return {};
  const double with_place = term.tf - middle * term.f;
  const double with_distance = term.fd - term.f * all.d / n;
  const double slope = (all.td - middle * all.d) / spread;
  const double own = term.ff - term.f * term.f / n - with_place * with_place / spread;
  const double common = with_distance - slope * with_place;
  if (!(own > kLeastOwn * n)) return {};
  return {common / own, common * common / own};
}

/// 1 at these samples and 0 at the others.
Term stepAfter(const Sums& before, const Sums& all) {
  return besideLine({before.count, before.count, before.t, before.d}, all);
}

/// t^2: a barrel, or the side of an ellipsoid.
Term bendOf(const Sums& all) { return besideLine({all.tt, all.tttt, all.ttt, all.ttd}, all); }

/// The samples along the axis, in slices.
class Profile {
 public:
  Profile(const Samples& samples, const Shape& shape, const Vec3& axis, const List<std::uint32_t>& inliers) {
    float high = -std::numeric_limits<float>::infinity();
    for (const std::uint32_t i : inliers) {
      places_.push_back(static_cast<float>(axis.dot(samples.point(i))));
      low_ = std::min(low_, places_.back()), high = std::max(high, places_.back());
    }
    length_ = high - low_;
    for (std::size_t k = 0; k < inliers.size(); ++k) {
      const double off = distance(shape, samples.point(inliers[k])) / samples.sigma[inliers[k]];
      slices_[sliceOf(k)].add(2.0 * shareOf(k) - 1.0, off);
    }
  }

  /// Of the k-th inlier.
  std::size_t sliceOf(std::size_t k) const {
    return std::min(static_cast<std::size_t>(shareOf(k) * kSlices), kSlices - 1);
  }

  /// How many slices lie before the clearest step, which has `least` samples on either side; 0 where none is clear, or
  /// a bend explains more.
  std::size_t clearestStep(double least) const {
    constexpr double kLeastHeight = 0.75;    // standard deviations
    constexpr double kLeastEvidence = 25.0;  // of noise alone 10 is rare, but it comes in waves
    Sums all, before;
    for (const Sums& slice : slices_) all.add(slice);
    double most = std::max(kLeastEvidence, bendOf(all).evidence);
    std::size_t cut = 0;
    for (std::size_t slice = 0; slice + 1 < kSlices; ++slice) {
      before.add(slices_[slice]);
      if (before.count < least || all.count - before.count < least) continue;
      const Term step = stepAfter(before, all);
      if (std::abs(step.height) < kLeastHeight || !(step.evidence > most)) continue;
      most = step.evidence;
      cut = slice + 1;
    }
    return cut;
  }

 private:
  /// Of the length, from 0 to 1.
  float shareOf(std::size_t k) const {
    constexpr float kShortest = 1e-6f;  // m
    return length_ > kShortest ? (places_[k] - low_) / length_ : 0.0f;
  }

  List<float> places_;  ///< m, along the axis
  float low_ = std::numeric_limits<float>::infinity(), length_ = 0.0f;
  std::array<Sums, kSlices> slices_;
};

}  // namespace

SampleParts axisStepParts(const Samples& samples, const Shape& shape, const List<std::uint32_t>& inliers,
                          std::size_t least) {
  const std::optional<Vec3> axis = axisOf(shape);
  if (!axis || inliers.size() < 2 * least) return {};
  const Profile profile(samples, shape, *axis, inliers);
  const std::size_t cut = profile.clearestStep(static_cast<double>(least));
  if (cut == 0) return {};
  SampleParts parts(2);
  for (std::size_t k = 0; k < inliers.size(); ++k) parts[profile.sliceOf(k) < cut ? 0 : 1].push_back(inliers[k]);
  return parts;
}

}  // namespace primitect
