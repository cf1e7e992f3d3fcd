// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points of one fit: gathered once for all kinds that are tried on them.
#pragma once

#include <cstdint>
#include <functional>

#include "core/frame_memory.h"
#include "core/noise.h"
#include "core/samples.h"
#include "core/seen_points.h"
#include "kernels/loops.h"
#include "primitect/primitives.h"

namespace primitect {

/// Some of the samples, by index.
struct SampleSet {
  const Samples& samples;
  const List<std::uint32_t>& indices;

  std::size_t size() const { return indices.size(); }
  Vec3 point(std::size_t k) const { return samples.point(indices[k]); }
  Vec3 normal(std::size_t k) const { return samples.normal(indices[k]); }
};

/// Points in float around their mean, so that no digits are lost, filled up to whole lanes.
class FitPoints {
 public:
  /// Points, normals, and as tolerance three standard deviations of their noise.
  void gather(const SampleSet& set);

  /// The same with this tolerance (m).
  void gather(const SampleSet& set, const std::function<double(const Vec3&)>& tolerance);

  /// Points without normals, whose moments are not asked for.
  void gather(const SeenPoints& seen, const NoiseModel& noise);

  /// So many of them, evenly taken, without normals, around the same middle.
  FitPoints thinned(std::size_t count) const;

  std::size_t size() const { return size_; }
  const Vec3& origin() const { return origin_; }
  const Vec3& middle() const { return middle_; }    ///< the mean point
  double reach() const;                             ///< m, from the middle to the farthest; after gather() of samples
  double meanSigma() const { return mean_sigma_; }  ///< m, noise of the distance to a surface
  kernels::FitPoints view() const { return {x_.data(), y_.data(), z_.data(), inverse_tolerance_.data(), x_.size()}; }
  kernels::MomentSums moments() const;
  /// inverse_variance: of each normal (1/rad^2), as many as the view has points.
  kernels::FlatNormals normals(const List<float>& inverse_variance) const {
    return {nx_.data(), ny_.data(), nz_.data(), inverse_variance.data()};
  }

 private:
  template <class ToleranceOf>
  void gatherWith(const SampleSet& set, const ToleranceOf& tolerance);

  std::size_t size_ = 0;
  Vec3 origin_ = Vec3::Zero(), middle_ = Vec3::Zero();
  double mean_sigma_ = 0.0;
  List<float> x_, y_, z_, nx_, ny_, nz_, inverse_tolerance_;
  List<float> once_;  ///< 1 for each point, 0 for what fills up
};

}  // namespace primitect
