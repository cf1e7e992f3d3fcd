// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which point of the whole cloud belongs to which detection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/frame_memory.h"
#include "core/label_runs.h"
#include "core/observed_part.h"
#include "core/point_runs.h"
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

  /// Of this cloud; see point_runs.h. All of a large one are looked at when they are asked for.
  const PointRuns& someRuns() const { return some_; }
  const PointRuns& allRuns();

  /// Labels every point of these runs with the index + 1 of the nearest detection whose surface is within the tolerance
  /// and whose observed part, enlarged by it, holds the point; 0 = none, or missing. Takes a tenth of the time where
  /// neighbours in the cloud are neighbours in space: runs of points that a shape does not come near are left out.
  void label(const std::vector<Detection>& detections, const Tolerance& tolerance, const PointRuns& runs,
             std::vector<std::uint32_t>& labels);

  /// Labels again what label() gave to detections that are not wanted any more, by their index, as if these were not
  /// there.
  /// labelled: the runs of these labels.
  void labelWithout(const std::vector<Detection>& detections, const List<bool>& wanted, const Tolerance& tolerance,
                    const PointRuns& runs, const List<LabelRun>& labelled, std::vector<std::uint32_t>& labels);

  /// Which points of a run are looked at.
  enum class Rows { all, every_second };

  /// A bit for each point of these runs (see PointRuns::measured), set where it is looked at and would get no label; of
  /// missing points any.
  void findUnexplained(const std::vector<Detection>& detections, const Tolerance& tolerance, const PointRuns& runs,
                       Rows rows, List<std::uint64_t>& unexplained);

 private:
  struct Target {
    kernels::FlatShape shape;
    ObservedPart part;
  };
  /// So many targets have a bit in one word.
  static constexpr std::size_t kTargetsPerWord = 32;

  void prepare(const std::vector<Detection>& detections, const List<bool>& wanted, const PointRuns& runs,
               const kernels::FlatTolerance& tolerance);
  void labelWithin(const PointRuns& runs, const kernels::FlatTolerance& tolerance, std::uint32_t* labels);
  void findAllowed(const PointRuns& runs, const kernels::FlatTolerance& tolerance);
  void findNear(const PointRuns& runs, std::size_t target);
  bool hasTargetsOfRunBefore(const PointRuns& runs, std::size_t k) const;
  /// One run after the other, from the first on.
  void gatherTargets(const PointRuns& runs, std::size_t k);
  void labelRun(std::size_t run, const kernels::FlatTolerance& tolerance, std::uint32_t* labels) const;
  kernels::RunOfPoints pointsFrom(std::size_t begin) const;
  std::uint64_t unexplainedOf(std::size_t run, const kernels::FlatTolerance& tolerance, Rows rows) const;

  const Cloud* cloud_ = nullptr;
  PointRuns all_, some_;
  bool has_all_ = false;
  List<float> distance_, depth_, allowed_;  ///< of the balls around some runs (m)
  List<Target> targets_;                    ///< of each detection
  List<std::uint32_t> near_, border_;       ///< bits of the targets that a run is near to, and near the border of
  List<kernels::LabelTarget> of_run_;       ///< what one run is near to
  List<kernels::FlatSide> sides_;           ///< of a part near a run
};

/// The same for a cloud that is labelled once.
void labelPoints(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                 std::vector<std::uint32_t>& labels);

}  // namespace primitect
