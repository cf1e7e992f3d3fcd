// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which point of the whole cloud belongs to which detection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/observed_part.h"
#include "core/tolerance.h"
#include "kernels/loops.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Of one frame after the other; its buffers are kept.
class Labeling {
 public:
  /// Looks where the points are; the cloud must stay until the next one.
  void begin(const Cloud& cloud);

  /// Labels every point with the index + 1 of the nearest detection whose surface is within the tolerance and whose
  /// observed part, enlarged by it, holds the point; 0 = none, or missing. Takes a tenth of the time where neighbours
  /// in the cloud are neighbours in space: runs of points that a shape does not come near are left out.
  void label(const std::vector<Detection>& detections, const Tolerance& tolerance, std::vector<std::uint32_t>& labels);

 private:
  /// A run of points against a shape.
  enum class Near : std::uint8_t { no, within, border };
  struct Target {
    kernels::FlatShape shape;
    ObservedPart part;
  };

  void findAllowed(const kernels::FlatTolerance& tolerance);
  void findNear(const Target& target, Near* near);
  kernels::FlatPart sidesNear(const kernels::FlatPart& part, std::size_t run);
  void labelRuns(std::size_t first, std::size_t last, const kernels::FlatTolerance& tolerance, std::uint32_t* labels);

  const Cloud* cloud_ = nullptr;
  std::vector<float> x_, y_, z_, radius_;          ///< of balls around the runs (m)
  std::vector<float> distance_, depth_, allowed_;  ///< of these balls (m)
  std::vector<Target> targets_;                    ///< of each detection
  std::vector<kernels::FlatSide> sides_;           ///< of a part near a run
  std::vector<Near> near_;                         ///< of all runs and each detection
  std::vector<float> point_allowed_, nearest_;     ///< of the points of some runs (m)
};

/// The same for a cloud that is labelled once.
void labelPoints(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                 std::vector<std::uint32_t>& labels);

}  // namespace primitect
