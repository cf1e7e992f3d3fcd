// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The accumulator arrays of one reference, and reading the strongest shape of each kind from them.
#pragma once

#include <optional>
#include <vector>

#include "core/axis_ball.h"
#include "kernels/kernels.h"
#include "primitect/params.h"

namespace primitect {

/// Where an accumulator peaks: the votes of the strongest bin and its neighbours together, and the parameters.
struct Peak {
  double votes = 0.0;
  double radius = 0.0;        ///< R or s_r (m)
  double angle = 0.0;         ///< cylinder: phi (rad)
  Vec3 axis = Vec3::UnitZ();  ///< cone: unit, sign not known
};

/// From where a curved surface is seen: outside, or inside.
enum class Side { convex, concave };
constexpr Side kSides[] = {Side::convex, Side::concave};

/// Whether surfaces seen from that side are looked for (params.convexity).
bool votes(Side side, const Params& params);

/// Bins of all four kinds (paper, table I and sec. "Choice of parameters"), of the curved ones for each side that
/// votes.
class Accumulators {
 public:
  explicit Accumulators(const Params& params);

  /// Width of the bins of R and s_r (m), 1 at first.
  void setRadiusBin(double radius_bin) { radius_bin_ = radius_bin; }

  void clear();
  kernels::Accumulators view();

  /// Nothing when there are no votes.
  std::optional<Peak> planePeak() const;
  std::optional<Peak> spherePeak(Side side) const;
  std::optional<Peak> cylinderPeak(Side side) const;
  std::optional<Peak> conePeak(Side side) const;

 private:
  /// Empty where the side does not vote.
  struct Curved {
    std::vector<float> sphere, cylinder, cone;

    kernels::CurvedBins view() { return {sphere.data(), cylinder.data(), cone.data()}; }
  };

  const Curved& of(Side side) const { return side == Side::convex ? convex_ : concave_; }
  double binRadius(int bin) const { return (bin + 0.5) * radius_bin_; }

  double radius_bin_ = 1.0;
  int radius_bins_;
  int phi_bins_;
  bool average_bins_;  ///< peaks are weighted averages over neighbouring bins (else: bin centres)
  AxisBall ball_;
  float plane_ = 0.0f;
  Curved convex_, concave_;
};

}  // namespace primitect
