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

Shape Measurement::fitted(const Shape& shape, const SeenPoints& all, const SeenPoints& clear) const {
  FitPoints points;
  Shape start = shape;
  if (kindOf(shape) == Kind::cylinder || kindOf(shape) == Kind::cone) {
    // What tells one from the other grows with the length that was seen, of which clear points lack both ends.
    points.gather(all, noise_);
    start = refineOnPoints(shape, points, limits_);
  }
  points.gather(clear, noise_);
  const std::optional<Shape> refined = refine(start, points);
  const Shape fit = refined && limits_.hold(*refined) ? *refined : start;
  const NoiseDirection direction = noise_.depth_share > 0.0 ? NoiseDirection::along_ray : NoiseDirection::any;
  const Shape unbiased = withoutBias(fit, clear, sigma_, direction);
  return limits_.hold(unbiased) ? unbiased : fit;
}

Detection Measurement::of(const Detection& detection, const LabelledPoints& labelled,
                          const std::vector<std::uint32_t>& clear) const {
  SeenPoints points, clear_points;
  points.gather(cloud_, labelled.index);
  clear_points.gather(cloud_, clear);
  Detection measured = detection;
  measured.shape = canonical(fitted(detection.shape, points, clear_points));
  measured.extent = measureExtent(measured.shape, points);
  measured.inlier_count = static_cast<std::uint32_t>(labelled.all);
  measured.rms_error = rmsDistance(measured.shape, points);
  measured.coverage = measureCoverage(measured.shape, measured.extent, points);
  measured.truncated = truncation_.find(measured.shape, measured.extent, labelled.index);
  const double shared = measureSharedNoise(measured.shape, clear_points, sigma_);
  const Uncertainty uncertainty = measureUncertainty(measured.shape, measured.extent, clear_points, sigma_, shared);
  measured.covariance = uncertainty.pose;
  measured.radius_stddev = static_cast<float>(uncertainty.radius_stddev);
  measured.half_angle_stddev = static_cast<float>(uncertainty.half_angle_stddev);
  return measured;
}

}  // namespace primitect
