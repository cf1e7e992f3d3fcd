// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One cloud message in, one primitive message out: what the nodelet does with a frame, without topics.
#pragma once

#include <primitect/PrimitiveArray.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "messages.h"
#include "primitect/detector.h"
#include "primitect/latency_governor.h"
#include "primitect/moved_image.h"
#include "steady_time.h"

namespace primitect::ros_layer {

/// Of a cloud that comes without a transform.
enum class CameraPlace {
  from_image,  ///< at the origin, or where the points tell (moved_image.h)
  said         ///< at the origin
};

class FramePipeline {
 public:
  /// Throws std::invalid_argument as Detector does.
  explicit FramePipeline(const Params& params);
  FramePipeline(const FramePipeline&) = delete;
  FramePipeline& operator=(const FramePipeline&) = delete;

  /// Throws std::invalid_argument as Detector does; then the old ones stay.
  void setParams(const Params& params);
  const Params& params() const { return detector_.params(); }

  /// Reads the cloud, moves it to the sensor where it comes in another frame, and detects: primitives are in the frame
  /// of the sensor. An image that somebody moved, or a list of its points, is searched from where its camera was
  /// (moved_image.h), where nobody says; primitives are in the frame of the cloud then. When the status is not OK,
  /// problem() says why. processing_time is left 0. With max_latency, times().begin() is when the frame came.
  /// with_labels: labels() will be asked for. Else large images are read no finer than they are worked on.
  /// The result may be changed; it is valid until the next call.
  PrimitiveArray& process(const sensor_msgs::PointCloud2& message, bool with_labels = false,
                          const std::optional<Eigen::Isometry3d>& sensor_from_cloud = std::nullopt,
                          CameraPlace place = CameraPlace::from_image);

  /// For a cloud whose place is not known: no primitives, status NO_TRANSFORM, and this problem.
  PrimitiveArray& withoutTransform(const sensor_msgs::PointCloud2& message, const std::string& problem);

  /// Its primitives are published: what it took so far decides on the effort of the next one.
  void published();

  /// Of max_latency; null: that is off.
  const LatencyGovernor* governor() const { return governor_ ? &*governor_ : nullptr; }

  /// Forgets how long frames took.
  void startAnew();

  /// What was wrong with the last cloud and what was expected; empty: it was searched.
  const std::string& problem() const { return problem_; }

  /// Of the last cloud: how often shapes were tried that did not come out, and why.
  const Refusals& refusals() const { return refusals_; }

  /// The last cloud could be read.
  bool hasCloud() const { return has_cloud_; }

  /// Of the last cloud, where its own points told that it is elsewhere; in its frame.
  const std::optional<Eigen::Isometry3d>& foundCamera() const { return camera_.cloud_from_camera; }

  /// What told it, where one was found.
  CameraClue cameraClue() const { return camera_.clue; }

  /// False: its points contradict that a sensor at the origin saw them. Empty: there were none that could tell.
  std::optional<bool> seenFromOrigin() const;

  /// Of what the last cloud measured, the share beyond max_depth; 0 of none.
  double shareBeyond() const;

  /// True: a list of points, which was searched as if a sensor at the origin had seen it; they do not tell. Also of one
  /// with normals: by default they are turned towards the origin.
  bool isListFromOrigin() const;

  /// True: most of its normals, kept as they came, are turned away from a sensor at the origin.
  bool normalsFaceAway() const { return has_cloud_ && detector_.result().normals_face_away; }

  /// Of the last cloud; see Detections.
  double imageNoise() const { return has_cloud_ ? detector_.result().image_noise : 0.0; }
  double depthWaves() const { return has_cloud_ ? detector_.result().depth_waves : -1.0; }

  /// The last cloud, if there is one, which came as this message, as the sensor saw it: cut at no depth, in the frame
  /// of the sensor.
  Cloud seen(const sensor_msgs::PointCloud2& message) const;

  /// Of its points, where it was processed with labels: index of the detection + 1, 0 = none.
  const std::vector<std::uint32_t>& pointLabels();

  /// What was found in it, where it was searched, in the frame of the sensor.
  const Detections& detections() const { return detector_.result(); }

  /// Of the last cloud, if there is one, in the frame of the primitives; labels of what was processed with them.
  sensor_msgs::PointCloud2 labels(const std_msgs::Header& header);
  sensor_msgs::PointCloud2 normals(const std_msgs::Header& header) const;

  StageTimes& times() { return times_; }

  /// Called with the name of each stage when it is done, "read" first: for measuring by another clock than times().
  void onStageDone(std::function<void(const char*)> callback) { stage_done_ = std::move(callback); }

 private:
  Detector makeDetector(const Params& params);
  void stageDone(const char* stage);
  void resetGovernor();
  void lookForCamera(const sensor_msgs::PointCloud2& message, bool with_labels);
  const Detections& detect();
  std::string problemOf(const Detections& detections) const;

  StageTimes times_;
  std::function<void(const char*)> stage_done_;
  Detector detector_;
  std::optional<LatencyGovernor> governor_;
  Cloud cloud_;
  std::optional<Eigen::Isometry3d> sensor_from_cloud_;  ///< as it was told, of the last cloud
  CameraSearch camera_;                                 // of the last cloud, where nobody says where its camera was
  Detections in_frame_of_cloud_;                        ///< with a found camera
  bool has_cloud_ = false;
  Status status_ = Status::ok;  ///< of the last cloud
  Refusals refusals_;
  MessageWriter message_writer_;
  std::vector<std::uint32_t> labels_;
  std::string problem_;
};

}  // namespace primitect::ros_layer
