// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Putting the measures of a detection together; see measurement.h.
#include "core/measurement.h"

#include <optional>

#include "core/bias.h"
#include "core/covariance.h"
#include "core/coverage.h"
#include "core/extent.h"
#include "core/fitting.h"
#include "core/shared_noise.h"

namespace primitect {
namespace {

DepthRange rangeOf(const Params& params) {
  return {static_cast<float>(params.min_depth), static_cast<float>(params.max_depth)};
}

}  // namespace

Measurement::Measurement(const Cloud& cloud, const ImageRays& rays, const Params& params, const NoiseModel& noise,
                         const Limits& limits)
    : cloud_(cloud), noise_(noise), limits_(limits), sigma_(noise), truncation_(cloud, rays, rangeOf(params), sigma_) {}

Shape Measurement::fitted(const Shape& shape) {
  Shape start = shape;
  if (kindOf(shape) == Kind::cylinder || kindOf(shape) == Kind::cone) {
    // What tells one from the other grows with the length that was seen, of which clear points lack both ends.
    fit_points_.gather(points_, noise_);
    start = refineOnPoints(shape, fit_points_, limits_);
  }
  fit_points_.gather(clear_, noise_);
  const std::optional<Shape> refined = refine(start, fit_points_);
  const Shape fit = refined && limits_.hold(*refined) ? *refined : start;
  const NoiseDirection direction = noise_.depth_share > 0.0 ? NoiseDirection::along_ray : NoiseDirection::any;
  const Shape unbiased = withoutBias(fit, clear_, sigma_, direction);
  const Shape last = limits_.hold(unbiased) ? unbiased : fit;
  // A few clear points may not hold a shape where all of its points are.
  constexpr double kWorse = 1.5;
  return rmsDistance(last, points_) <= kWorse * rmsDistance(start, points_) ? last : start;
}

Detection Measurement::of(const Detection& detection, const LabelledPoints& labelled,
                          const List<std::uint32_t>& clear) {
  points_.gather(cloud_, labelled.index);
  clear_.gather(cloud_, clear);
  Detection measured = detection;
  measured.shape = canonical(fitted(detection.shape));
  measured.extent = measureExtent(measured.shape, points_);
  measured.inlier_count = static_cast<std::uint32_t>(labelled.all);
  measured.rms_error = rmsDistance(measured.shape, points_);
  measured.coverage = measureCoverage(measured.shape, measured.extent, points_);
  measured.truncated = truncation_.find(measured.shape, measured.extent, labelled.index);
  const double shared = measureSharedNoise(measured.shape, clear_, sigma_);
  const Uncertainty uncertainty = measureUncertainty(measured.shape, measured.extent, clear_, sigma_, shared);
  measured.covariance = uncertainty.pose;
  measured.radius_stddev = static_cast<float>(uncertainty.radius_stddev);
  measured.half_angle_stddev = static_cast<float>(uncertainty.half_angle_stddev);
  return measured;
}

}  // namespace primitect
