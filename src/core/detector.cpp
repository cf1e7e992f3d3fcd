// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The pipeline: rounds of sample, normals, vote, cluster, segment, extent.
#include "primitect/detector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/clustering.h"
#include "core/extent.h"
#include "core/labeling.h"
#include "core/neighbors.h"
#include "core/normals.h"
#include "core/pair_voting.h"
#include "core/sampling.h"
#include "core/segmentation.h"
#include "core/verification.h"

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

  double largestRadius() const { return params.radius_bin * params.radius_bins * result.scene_diameter; }

  /// Tolerances of this frame; the tight one waits for the first candidates where the noise has to be measured.
  void setTolerances(const Cloud& cloud) {
    loose = {params.inlier_distance * result.scene_diameter, 0.0, std::cos(params.inlier_angle_deg * M_PI / 180.0)};
    tight = loose;
    const bool depth_camera = cloud.organized() && *std::min_element(samples.z.begin(), samples.z.end()) > 0.0f;
    if (params.verify && depth_camera) tight.distance_per_depth = params.inlier_depth_share;
  }

  /// From candidates to segments, by votes alone or checked on the samples.
  void select(int round) {
    if (!params.verify) return selectSegments(samples, candidates, params, loose, segments);
    if (round == 0 && tight.distance_per_depth <= 0.0) {
      tight.distance = estimateNoiseTolerance(samples, candidates, loose);
    }
    verifyCandidates(samples, candidates, params, loose, tight, largestRadius(), segments);
  }

  /// Gives all samples drawn so far to the segments.
  void assign() {
    all_samples.append(samples);
    assignSamples(all_samples, params, tight, segments);
    if (!params.verify) return;
    refineSegments(all_samples, params, tight, largestRadius(), segments);
    assignSamples(all_samples, params, tight, segments);
  }

  /// Forgets the last frame and looks whether this one can be used.
  void begin(const Cloud& cloud) {
    samples.clear();
    all_samples.clear();
    segments.clear();
    neighbors.reset();
    result = {};
    result.points_in = static_cast<std::uint32_t>(cloud.size());
    result.points_used = cloud.valid_count;
    result.status = statusOf(cloud);
  }

  /// Draws the samples of a round from what no earlier round explained; false when there is nothing left to vote.
  bool draw(const Cloud& cloud, int round) {
    labels.clear();
    // Wider than what makes an inlier: the outskirts of a noisy surface are no new one.
    constexpr double kOutskirts = 2.0;
    if (round > 0) labelPoints(cloud, result.items, tight.scaled(kOutskirts), labels);
    // No point votes twice: what was drawn counts as taken.
    for (const std::uint32_t i : all_samples.index) labels[i] = 1;
    drawSamples(cloud, labels, params.samples, static_cast<std::uint64_t>(params.seed) + round, samples);
    if (round > 0) return samples.size() >= kFewestPoints;
    result.scene_diameter = params.scene_diameter > 0.0 ? params.scene_diameter : boundingBoxDiagonal(samples);
    // All points in one place have no scale and no normals.
    if (!(result.scene_diameter > 0.0)) result.status = Status::too_few_points;
    setTolerances(cloud);
    return result.status == Status::ok;
  }

  void describeSegments() {
    result.items.clear();
    for (const Segment& segment : segments) {
      if (!segment.inliers.empty()) result.items.push_back(describe(segment, all_samples, inliers));
    }
    result.samples = static_cast<std::uint32_t>(all_samples.size());
  }

  Params params;
  std::function<void(const char*)> stage_done;
  PairVoting voting;
  Samples samples;      ///< of this round
  Samples all_samples;  ///< of all rounds of this frame
  Tolerance loose;      ///< to gather the samples of a candidate
  Tolerance tight;      ///< of what belongs to a shape
  std::vector<Candidate> candidates;
  std::vector<Segment> segments;
  std::vector<Vec3> inliers;
  std::vector<std::uint32_t> labels;
  std::unique_ptr<NeighborSearch> neighbors;  ///< in this frame's cloud, where normals need it
  Detections result;
};

Detector::Detector(const Params& params) : work_(std::make_unique<Workspace>(checked(params))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const Params& Detector::params() const { return work_->params; }

SampleView Detector::samples() const {
  const Samples& s = work_->all_samples;
  return {s.x, s.y, s.z, s.nx, s.ny, s.nz};
}

void Detector::onStageDone(std::function<void(const char*)> callback) { work_->stage_done = std::move(callback); }

const Detections& Detector::detect(const Cloud& cloud) {
  Workspace& w = *work_;
  w.begin(cloud);
  for (int round = 0; round < w.params.rounds && w.result.status == Status::ok; ++round) {
    const bool drawn = w.draw(cloud, round);
    w.done("sample");
    if (!drawn) break;
    estimateNormals(cloud, w.params, w.neighbors, w.samples);
    w.done("normals");
    w.voting.vote(w.samples, w.result.scene_diameter, w.candidates);
    w.done("vote");
    clusterCandidates(w.candidates, w.params, w.result.scene_diameter);
    w.done("cluster");
    w.select(round);
    w.assign();
    w.done("segment");
    w.describeSegments();
    w.done("extent");
  }
  return w.result;
}

void Detector::label(const Cloud& cloud, std::vector<std::uint32_t>& labels) const {
  labelPoints(cloud, work_->result.items, work_->tight, labels);
}

}  // namespace primitect
