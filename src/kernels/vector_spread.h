// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Interpolation votes, kLanes at a time: rows and weights as spreadLinear(), spreadCircular() and spreadOnBall() of
// scalar.cpp give them. For a kernel file that has included its lanes.
#pragma once

#include "kernels/kernels.h"
#include "kernels/vector_math.h"

namespace primitect::kernels {
namespace {

/// Position of R or s_r in its row: bins lower and lower + 1.
struct LayerLanes {
  Ints lower;
  Floats upper_weight;
};

/// A row with its share of a vote.
struct ShareLanes {
  Ints row;
  Floats weight;
};

/// A position on a circle of bins: the bins around it.
struct TurnLanes {
  Ints lower, upper;
  Floats upper_weight;
};

/// A direction on the ball: rings from the pole, and turns around it, less than 1.
struct BallPosition {
  Floats polar, turns;
};

Ints toInts(Floats v) { return __builtin_convertvector(v, Ints); }
Floats toFloats(Ints v) { return __builtin_convertvector(v, Floats); }
Floats clamped(Floats v, float low, float high) { return smaller(larger(v, Floats{} + low), Floats{} + high); }

LayerLanes layersOf(Floats radius_in_bins, int bins, bool spread) {
  const float last = static_cast<float>(bins - 1);
  const Floats position = clamped(radius_in_bins - 0.5f, 0.0f, last);
  const Ints lower = toInts(smaller(position, Floats{} + (last - 1.0f)));
  const Floats fraction = position - toFloats(lower);
  return {lower, spread ? fraction : (fraction > 0.5f ? Floats{} + 1.0f : Floats{})};
}

/// Of bins that repeat after `period`; the position is in [0, 2 period).
TurnLanes turnOf(Floats position, Ints period) {
  Ints lower = toInts(position);
  const Floats fraction = position - toFloats(lower);
  lower -= (lower >= period) & period;
  const Ints upper = lower + 1;
  return {lower, upper - ((upper == period) & period), fraction};
}

/// The strongest share takes all, the first one of several.
template <int kShares>
void strongestOnly(ShareLanes (&shares)[kShares]) {
  Floats most = shares[0].weight;
  for (const ShareLanes& share : shares) most = larger(share.weight, most);
  Ints taken = {};
  for (ShareLanes& share : shares) {
    const Ints strongest = (share.weight == most) & ~taken;
    share.weight = strongest ? Floats{} + 1.0f : Floats{};
    taken |= strongest;
  }
}

/// Rings of an AxisBall in one look-up each: first bin, bins until they repeat, bins of a full turn.
class RingTable {
 public:
  explicit RingTable(const AxisBall& ball) : rings_(ball.rings), rings_per_radian_(1.0f / ball.step) {
    for (int ring = 0; ring <= ball.rings && ring < kMostRings; ++ring) {
      const int size = ring == 0 ? 1 : ball.ring_size[ring];
      const int start = ring == 0 ? 0 : ball.ring_start[ring];
      ring_[ring] = start << 16 | (ring == ball.rings ? size / 2 : size) << 8 | size;
    }
    sector_ = 2.0f * kPi / static_cast<float>(ball.ring_size[1]);
    sine_of_sector_ = smallSine(Floats{} + sector_)[0];
  }

  /// Where an axis of any sign and length meets the ball.
  BallPosition locate(Floats x, Floats y, Floats z) const {
    const Ints flip = z < 0.0f;
    const Floats polar_angle = angleInQuadrant(squareRoot(x * x + y * y), absolute(z));
    const Floats angle = angleInPlane(flip ? -y : y, flip ? -x : x);
    return {clamped(polar_angle * rings_per_radian_, 0.0f, static_cast<float>(rings_)),
            smaller(angle * (0.5f / kPi), Floats{} + kLessThanOne)};
  }

  void spread(const BallPosition& position, ShareLanes (&shares)[4]) const {
    const Ints inner = toInts(smaller(position.polar, Floats{} + static_cast<float>(rings_ - 1)));
    const Floats outer_weight = position.polar - toFloats(inner);
    spreadOnRing(inner, position.turns, 1.0f - outer_weight, shares[0], shares[1]);
    const Floats within = spreadOnRing(inner + 1, position.turns, outer_weight, shares[2], shares[3]);
    const Ints around_pole = inner == 0;
    if (any(around_pole)) spreadAroundPole(around_pole, position.polar, within, shares);
  }

 private:
  static constexpr float kLessThanOne = 0.9999999f;  // stays below n when multiplied by n
  static constexpr int kMostRings = 64;              // 45 of the smallest bins, 2 deg

  /// Returns the share of the second of both bins.
  Floats spreadOnRing(Ints ring, Floats turns, Floats weight, ShareLanes& lower, ShareLanes& upper) const {
    const Ints entry = gather(ring_, ring);
    const Ints start = entry >> 16;
    const TurnLanes side = turnOf(turns * toFloats(entry & 0xff), entry >> 8 & 0xff);
    lower = {start + side.lower, weight * (1.0f - side.upper_weight)};
    upper = {start + side.upper, weight * side.upper_weight};
    return side.upper_weight;
  }

  /// Barycentric weights in the flat triangle of the pole and two bins of ring 1; see spreadAroundPole() of scalar.cpp.
  void spreadAroundPole(Ints around_pole, Floats radius, Floats within, ShareLanes (&shares)[4]) const {
    const Floats angle = within * sector_;
    const Floats first = radius * smallSine(sector_ - angle) / sine_of_sector_;
    const Floats second = radius * smallSine(angle) / sine_of_sector_;
    const Floats scale = 1.0f / larger(first + second, Floats{} + 1.0f);
    const Floats pole = larger(1.0f - (first + second) * scale, Floats{});
    const Floats weights[4] = {Floats{}, pole, first * scale, second * scale};
    for (int k = 0; k < 4; ++k) shares[k].weight = around_pole ? weights[k] : shares[k].weight;
  }

  int ring_[kMostRings];
  int rings_;
  float rings_per_radian_, sector_, sine_of_sector_;
};

}  // namespace
}  // namespace primitect::kernels
