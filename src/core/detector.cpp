// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The pipeline: sample, normals, vote, cluster, segment, extent.
#include "primitect/detector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/clustering.h"
#include "core/extent.h"
#include "core/normals.h"
#include "core/pair_voting.h"
#include "core/sampling.h"
#include "core/segmentation.h"

namespace primitect {
namespace {

/// Fewer points than this cannot tell a shape from chance.
constexpr std::uint32_t kFewestPoints = 16;

Params checked(const Params& params) {
  checkParams(params);
  return params;
}

Status statusOf(const Cloud& cloud) {
  if (cloud.valid_count == 0) return Status::empty_input;
  return cloud.valid_count < kFewestPoints ? Status::too_few_points : Status::ok;
}

float rmsDistance(const Shape& shape, const std::vector<Vec3>& points) {
  double sum = 0.0;
  for (const Vec3& point : points) sum += distance(shape, point) * distance(shape, point);
  return static_cast<float>(std::sqrt(sum / static_cast<double>(points.size())));
}

Detection describe(const Segment& segment, const Samples& samples, std::vector<Vec3>& inliers) {
  inliers.clear();
  for (const std::uint32_t i : segment.inliers) inliers.push_back(samples.point(i));
  Detection detection;
  detection.shape = canonical(segment.candidate.shape);
  detection.extent = measureExtent(detection.shape, inliers);
  detection.votes = static_cast<float>(segment.candidate.votes);
  detection.inlier_count = static_cast<std::uint32_t>(inliers.size());
  detection.rms_error = rmsDistance(detection.shape, inliers);
  return detection;
}

}  // namespace

/// What a detector keeps between frames so that it need not be allocated anew.
struct Detector::Workspace {
  explicit Workspace(const Params& checked_params) : params(checked_params), voting(checked_params) {}

  void done(const char* stage) const {
    if (stage_done) stage_done(stage);
  }

  Params params;
  std::function<void(const char*)> stage_done;
  PairVoting voting;
  Samples samples;
  std::vector<Candidate> candidates;
  std::vector<Segment> segments;
  std::vector<Vec3> inliers;
  Detections result;
};

Detector::Detector(const Params& params) : work_(std::make_unique<Workspace>(checked(params))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const Params& Detector::params() const { return work_->params; }

SampleView Detector::samples() const {
  const Samples& s = work_->samples;
  return {s.x, s.y, s.z, s.nx, s.ny, s.nz};
}

void Detector::onStageDone(std::function<void(const char*)> callback) { work_->stage_done = std::move(callback); }

const Detections& Detector::detect(const Cloud& cloud) {
  Workspace& w = *work_;
  w.samples.clear();
  w.result = {};
  w.result.points_in = static_cast<std::uint32_t>(cloud.size());
  w.result.points_used = cloud.valid_count;
  w.result.status = statusOf(cloud);
  if (w.result.status != Status::ok) return w.result;

  drawSamples(cloud, w.params.samples, w.params.seed, w.samples);
  const double diameter = w.params.scene_diameter > 0.0 ? w.params.scene_diameter : boundingBoxDiagonal(w.samples);
  w.done("sample");
  // All points in one place have no scale and no normals.
  if (!(diameter > 0.0)) w.result.status = Status::too_few_points;
  if (w.result.status != Status::ok) return w.result;

  estimateNormals(cloud, w.params, w.samples);
  w.done("normals");

  w.voting.vote(w.samples, diameter, w.candidates);
  w.done("vote");

  clusterCandidates(w.candidates, w.params, diameter);
  w.done("cluster");

  segmentSamples(w.samples, w.candidates, w.params, diameter, w.segments);
  w.done("segment");

  for (const Segment& segment : w.segments) {
    if (!segment.inliers.empty()) w.result.items.push_back(describe(segment, w.samples, w.inliers));
  }
  w.result.samples = static_cast<std::uint32_t>(w.samples.size());
  w.result.scene_diameter = diameter;
  w.done("extent");
  return w.result;
}

void Detector::label(const Cloud& cloud, std::vector<std::uint32_t>& labels) const {
  const Detections& result = work_->result;
  const double margin = work_->params.inlier_distance * result.scene_diameter;
  labels.assign(cloud.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const Vec3 point(cloud.x[i], cloud.y[i], cloud.z[i]);
    double nearest = margin;
    for (std::size_t k = 0; k < result.items.size(); ++k) {
      const Detection& detection = result.items[k];
      const double away = std::abs(distance(detection.shape, point));
      if (!(away < nearest) || !contains(detection.shape, detection.extent, point, margin)) continue;
      nearest = away;
      labels[i] = static_cast<std::uint32_t>(k + 1);
    }
  }
}

}  // namespace primitect
