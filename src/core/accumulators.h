// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The accumulator arrays of one reference, and reading the strongest shape of each kind from them.
#pragma once

#include <optional>
#include <vector>

#include "core/axis_ball.h"
#include "kernels/kernels.h"

namespace primitect {

/// Where an accumulator peaks: the votes of the strongest bin and its neighbours together, and the parameters.
struct Peak {
  double votes = 0.0;
  double radius = 0.0;        ///< R or s_r (m)
  double angle = 0.0;         ///< cylinder: phi (rad)
  Vec3 axis = Vec3::UnitZ();  ///< cone: unit, sign not known
};

/// Bins of all four kinds (paper, table I and sec. "Choice of parameters").
class Accumulators {
 public:
  /// angle_bin in rad. average_bins: peaks are weighted averages over neighbouring bins (else: bin centres).
  Accumulators(int radius_bins, double angle_bin, bool average_bins);

  /// Width of the bins of R and s_r (m), 1 at first.
  void setRadiusBin(double radius_bin) { radius_bin_ = radius_bin; }

  void clear();
  kernels::Accumulators view();

  /// Nothing when there are no votes.
  std::optional<Peak> planePeak() const;
  std::optional<Peak> spherePeak() const;
  std::optional<Peak> cylinderPeak() const;
  std::optional<Peak> conePeak() const;

 private:
  double binRadius(int bin) const { return (bin + 0.5) * radius_bin_; }

  double radius_bin_ = 1.0;
  int radius_bins_;
  int phi_bins_;
  bool average_bins_;
  AxisBall ball_;
  float plane_ = 0.0f;
  std::vector<float> sphere_, cylinder_, cone_;
};

}  // namespace primitect
