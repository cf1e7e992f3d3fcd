// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Read, detect, write: each once a frame.
#include "frame_pipeline.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "cloud_reader.h"
#include "io/depths_text.h"
#include "io/share_beyond.h"
#include "output_clouds.h"
#include "primitect/detector.h"
#include "primitect/transforms.h"

namespace primitect::ros_layer {
namespace {

std::string metres(const char* name, double value) {
  return std::string(name) + " (" + (value > 0.0 ? valueText(value) + " m)" : "off)");
}

std::string depthRangeText(double min_depth, double max_depth) {
  return "between " + metres("min_depth", min_depth) + " and " + metres("max_depth", max_depth);
}

/// Where the measured points of a cloud are that no range has cut.
std::string measuredText(const Cloud& cloud) {
  if (cloud.valid_count == 0) return "none of its points is measured";
  return "those measured are " + io::depthsText(cloud) +
         (io::mayBeInMillimetres(cloud) ? ": are they millimetres?" : "");
}

std::uint32_t pointsIn(const sensor_msgs::PointCloud2& message) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(std::uint64_t{message.width} * message.height, kMost));
}

Detections nothing(Status why) {
  Detections result;
  result.status = why;
  return result;
}

}  // namespace

FramePipeline::FramePipeline(const Params& params) : detector_(makeDetector(params)) { resetGovernor(); }

Detector FramePipeline::makeDetector(const Params& params) {
  Detector detector(params);
  detector.onStageDone([this](const char* stage) { stageDone(stage); });
  return detector;
}

void FramePipeline::stageDone(const char* stage) {
  times_.stageDone(stage);
  if (stage_done_) stage_done_(stage);
}

void FramePipeline::setParams(const Params& params) {
  detector_ = makeDetector(params);
  resetGovernor();
}

void FramePipeline::startAnew() {
  times_.clear();
  resetGovernor();
}

void FramePipeline::resetGovernor() {
  governor_.reset();
  if (params().max_latency > 0.0) governor_.emplace(params().max_latency, leastShare(params()));
}

const Detections& FramePipeline::detect() {
  if (!governor_) return detector_.detect(cloud_);
  governor_->beginFrame();
  return detector_.detect(cloud_, {governor_->share(), [this] { return governor_->shareInTime(times_.elapsed()); }});
}

void FramePipeline::published() {
  // A cloud that was not searched says nothing about the time that searching takes.
  if (governor_ && status_ == Status::ok) governor_->endFrame(times_.elapsed());
}

/// Leaves the cloud before its camera, cut, where it is an image, or a list of its points, that was moved.
void FramePipeline::lookForCamera(const sensor_msgs::PointCloud2& message, bool with_labels) {
  const DepthRange range = depthRangeOf(params());
  // What was cut off may be so along the wrong axis; that it can be read is known.
  const auto readWhole = [&] { readCloud(message, DepthRange(), {params().use_cloud_normals, true}, cloud_); };
  std::optional<CameraSearch> found = searchForCameraInCut(cloud_);
  const bool cut_tells = found.has_value();
  if (!cut_tells) {
    readWhole();
    found = searchForCamera(cloud_);
  }
  camera_ = *found;
  if (camera_.cloud_from_camera) {
    if (cut_tells) readWhole();
    cloud_.move(camera_.cloud_from_camera->inverse(), range);
  } else if (!cut_tells) {
    readCloud(message, range, {params().use_cloud_normals, with_labels}, cloud_);
  }
}

PrimitiveArray& FramePipeline::process(const sensor_msgs::PointCloud2& message, bool with_labels,
                                       const std::optional<Eigen::Isometry3d>& sensor_from_cloud, CameraPlace place) {
  static const Detections kRejected = nothing(Status::rejected_input);
  const DepthRange range = depthRangeOf(params());
  // How many points of a moved cloud are within the range, and enough, shows when it was moved.
  const Wanted wanted = {params().use_cloud_normals, with_labels || sensor_from_cloud};
  problem_ = readCloud(message, sensor_from_cloud ? DepthRange() : range, wanted, cloud_);
  has_cloud_ = problem_.empty();
  sensor_from_cloud_ = sensor_from_cloud;
  camera_ = {};
  const bool from_image = !sensor_from_cloud && place == CameraPlace::from_image;
  if (has_cloud_ && from_image) lookForCamera(message, with_labels);
  if (has_cloud_ && sensor_from_cloud) cloud_.move(*sensor_from_cloud, range);
  stageDone("read");
  const Detections& detected = has_cloud_ ? detect() : kRejected;
  if (camera_.cloud_from_camera) {
    in_frame_of_cloud_ = detected;
    transformDetections(*camera_.cloud_from_camera, in_frame_of_cloud_);
  }
  const Detections& detections = camera_.cloud_from_camera ? in_frame_of_cloud_ : detected;
  status_ = detections.status;
  refusals_ = detections.refusals;
  if (problem_.empty()) problem_ = problemOf(detections);
  if (has_cloud_ && detections.points_used < kFewestPoints)
    problem_ += "; " + measuredText(seen(message));  // reads it once more, but nothing was done with it
  PrimitiveArray& written = message_writer_.write(detections, message.header);
  written.points_in = pointsIn(message);
  // Of a large image they are extrapolated from every second pixel or fewer, which are a little more than their share.
  written.points_used = std::min(written.points_used, written.points_in);
  for (Primitive& item : written.primitives) item.inlier_count = std::min(item.inlier_count, written.points_in);
  return written;
}

PrimitiveArray& FramePipeline::withoutTransform(const sensor_msgs::PointCloud2& message, const std::string& problem) {
  static const Detections kNoTransform = nothing(Status::no_transform);
  problem_ = problem;
  has_cloud_ = false;
  sensor_from_cloud_.reset();
  camera_ = {};
  status_ = kNoTransform.status;
  refusals_ = {};
  PrimitiveArray& written = message_writer_.write(kNoTransform, message.header);
  written.points_in = pointsIn(message);
  return written;
}

std::optional<bool> FramePipeline::seenFromOrigin() const {
  if (!has_cloud_) return std::nullopt;
  if (!detector_.result().seen_from_origin) return false;
  return status_ == Status::ok ? std::optional(true) : std::nullopt;
}

double FramePipeline::shareBeyond() const { return has_cloud_ ? io::shareBeyond(cloud_) : 0.0; }

bool FramePipeline::isListFromOrigin() const {
  return seenFromOrigin() == true && !cloud_.organized() && !foundCamera() && !camera_.at_origin;
}

std::string FramePipeline::problemOf(const Detections& detections) const {
  if (detections.status == Status::ok) return {};
  const std::string used = std::to_string(detections.points_used);
  if (detections.points_used >= kFewestPoints) return "all " + used + " measured points are in one place";
  return used + " of " + std::to_string(detections.points_in) + " points are measured and " +
         depthRangeText(params().min_depth, params().max_depth) + "; expected at least " +
         std::to_string(kFewestPoints);
}

Cloud FramePipeline::seen(const sensor_msgs::PointCloud2& message) const {
  Cloud whole;
  readCloud(message, DepthRange(), {params().use_cloud_normals, true}, whole);
  if (sensor_from_cloud_) whole.move(*sensor_from_cloud_, DepthRange());
  if (camera_.cloud_from_camera) whole.move(camera_.cloud_from_camera->inverse(), DepthRange());
  return whole;
}

const std::vector<std::uint32_t>& FramePipeline::pointLabels() {
  detector_.label(cloud_, labels_);
  return labels_;
}

sensor_msgs::PointCloud2 FramePipeline::labels(const std_msgs::Header& header) {
  const std::vector<std::uint32_t>& labels = pointLabels();
  if (!camera_.cloud_from_camera) return labelCloud(header, cloud_, labels, detector_.result());
  Cloud moved_back = cloud_;
  moved_back.move(*camera_.cloud_from_camera, DepthRange());
  return labelCloud(header, moved_back, labels, detector_.result());
}

sensor_msgs::PointCloud2 FramePipeline::normals(const std_msgs::Header& header) const {
  const SampleView samples = detector_.samples();
  if (!camera_.cloud_from_camera) return normalCloud(header, samples);
  Cloud moved_back;
  moved_back.reset(static_cast<std::uint32_t>(samples.count), 1, true);
  for (std::size_t i = 0; i < samples.count; ++i) {
    moved_back.setPoint(i, samples.x[i], samples.y[i], samples.z[i], DepthRange());
    moved_back.nx[i] = samples.nx[i], moved_back.ny[i] = samples.ny[i], moved_back.nz[i] = samples.nz[i];
  }
  moved_back.move(*camera_.cloud_from_camera, DepthRange());
  return normalCloud(header, {moved_back.x.data(), moved_back.y.data(), moved_back.z.data(), moved_back.nx.data(),
                              moved_back.ny.data(), moved_back.nz.data(), samples.count});
}

}  // namespace primitect::ros_layer
