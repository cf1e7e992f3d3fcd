// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The detector: a cloud in, primitives out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/params.h"
#include "primitect/primitives.h"

namespace primitect {

/// The samples of the last frame with their normals, structure of arrays, m; until the next frame.
struct SampleView {
  const float *x, *y, *z, *nx, *ny, *nz;
  std::size_t count;
};

/// Fewer points than this cannot tell a shape from chance.
constexpr std::uint32_t kFewestPoints = 16;

/// How much work a frame may be. The default is all of it: the result then depends on cloud and parameters alone.
/// Params::max_latency does nothing by itself: who has a clock asks a LatencyGovernor for the effort.
struct Effort {
  /// Of samples, references and closer_samples, (0, 1]; what is less than leastShare() counts as that. With verify
  /// min_inliers goes down with them, to no less than 12: the same surface gets fewer samples. min_votes stays.
  /// Where a depth camera took the cloud, and shapes are verified with its noise, three quarters of these numbers are
  /// all of it.
  double share = 1.0;
  /// Asked before each round but the first and before the closer look: the share of its samples that there is time for,
  /// up to 1. At 0, or what is no share, the rest of the search is skipped, and what was found so far is verified and
  /// measured. Empty: there is time for everything.
  std::function<double()> share_in_time;
};

/// Samples that every shape needs, however small the effort: fewer on one surface may be chance.
constexpr int kFewestInliers = 12;

/// The least share of the effort: it leaves 256 samples in a draw, unless the cloud is a small part of a depth image.
double leastShare(const Params& params);

/// Finds planes, spheres, cylinders and cones. Same cloud, parameters and kernel (kernel_choice.h): same result, bit
/// for bit. One detector serves one thread; its buffers are reused from frame to frame.
class Detector {
 public:
  /// Throws std::invalid_argument naming parameter, value and range when a parameter is out of its range.
  explicit Detector(const Params& params);
  ~Detector();
  Detector(Detector&&) noexcept;
  Detector& operator=(Detector&&) noexcept;

  const Params& params() const;

  /// Of the cloud all counts: min_depth and max_depth are for who fills it, as depthRangeOf() (depth_range.h).
  /// Never throws on data: an unusable cloud gives no primitives and the reason in status.
  /// The result is valid until the next call. Throws std::invalid_argument naming a share that is not in (0, 1].
  const Detections& detect(const Cloud& cloud, const Effort& effort = {});

  /// What the last detect() found.
  const Detections& result() const;

  /// The label of each point of the cloud given to the last detect(): index of its detection + 1, 0 = none.
  void label(const Cloud& cloud, std::vector<std::uint32_t>& labels) const;

  /// Samples of the last frame and their normals.
  SampleView samples() const;

  /// Called with the name of each stage when that stage of detect() is done ("sample", "normals", "vote", ...):
  /// for measuring from outside, as the core has no clock.
  void onStageDone(std::function<void(const char*)> callback);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> work_;
};

}  // namespace primitect
