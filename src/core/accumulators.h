// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The accumulator arrays of one reference, and reading the strongest shape of each kind from them.
#pragma once

#include <cstddef>
#include <optional>

#include "core/axis_ball.h"
#include "core/frame_memory.h"
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
  Accumulators(Accumulators&&) = default;
  Accumulators& operator=(Accumulators&&) = default;

  /// Gets ready for references that are paired with so many samples each; width of the bins of R and s_r in m.
  void prepare(double radius_bin, std::size_t samples);

  void clear();

  /// Where the kernels vote, after prepare() and clear().
  kernels::Accumulators& bins() { return bins_; }

  /// Nothing when there are no votes, or all of them together are hardly more than `beaten`.
  std::optional<Peak> planePeak() const;
  std::optional<Peak> spherePeak(Side side, double beaten = 0.0) const;
  std::optional<Peak> cylinderPeak(Side side, double beaten = 0.0) const;
  std::optional<Peak> conePeak(Side side, double beaten = 0.0) const;

 private:
  /// Empty where the side does not vote.
  struct CurvedMemory {
    List<float> sphere, cylinder, cone;
    List<int> cone_cells;  ///< of the many bins of cones a reference votes for few: only these are cleared
  };

  /// Bins in this memory, which then has room for the cells of a reference's votes.
  static kernels::CurvedBins binsIn(CurvedMemory& memory, std::size_t samples);
  static void clear(kernels::CurvedBins& bins, CurvedMemory& memory);

  const kernels::CurvedBins& of(Side side) const { return side == Side::convex ? bins_.convex : bins_.concave; }
  double binRadius(int bin) const { return (bin + 0.5) * radius_bin_; }

  double radius_bin_ = 1.0;
  bool average_bins_;  ///< peaks are weighted averages over neighbouring bins (else: bin centres)
  AxisBall ball_;
  CurvedMemory convex_, concave_;
  kernels::Accumulators bins_ = {};
};

}  // namespace primitect
