// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The nodelet primitect/detector: topics, parameters and warnings around a CloudSequence.
#pragma once

#include <dynamic_reconfigure/server.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <memory>
#include <string>

#include "cloud_sequence.h"
#include "detector_diagnostics.h"
#include "markers.h"
#include "parameters.h"
#include "transform_inbox.h"

namespace primitect::ros_layer {

class DetectorNodelet : public nodelet::Nodelet {
 public:
  ~DetectorNodelet() override;

  /// False when onInit() refused to start; the log says why.
  bool started() const { return started_; }

 private:
  void onInit() override;
  void start();
  void advertise();
  void stop();

  void onConnectionChange();
  void onCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void onReconfigure(DetectorConfig& config, std::uint32_t level);
  void onDiagnosticsTimer();

  void processCloud(const sensor_msgs::PointCloud2& cloud);
  void publishPictures(const PrimitiveArray& message);
  /// What is wrong with the last cloud and its frames, now and then; that a transform is there again. status: of the
  /// message for it.
  void tellProblems(std::uint8_t status);
  /// Once.
  void warnIfIncomplete(const std_msgs::Header& header);
  /// Once, or once more after parameters changed.
  void warnIfHopeless();
  /// Once, or once more after parameters changed.
  void warnIfNotSeenFromOrigin();
  /// As often, where nothing tells: of lists of points whose frame is not called an optical one.
  void warnIfOriginIsAssumed();
  /// Once, or once more after parameters changed.
  void tellFoundCamera();
  /// Once for each silence: a wrong topic is the most common mistake, and not everybody looks at diagnostics.
  void warnIfSilent();
  void startAnewIfTimeWentBack(const ros::Time& stamp);
  /// A TransformLookup, whose errors say what can be done.
  Eigen::Isometry3d lookup(const std::string& target, const std::string& source, const ros::Time& stamp);
  FramePipeline& pipeline() { return sequence_->pipeline(); }

  /// Callbacks are serial, but onInit() runs in another thread than they do.
  boost::recursive_mutex mutex_;
  bool started_ = false;

  std::unique_ptr<CloudSequence> sequence_;
  std::unique_ptr<DetectorDiagnostics> diagnostics_;
  MarkerWriter marker_writer_;
  bool with_labels_ = false;  ///< the last cloud was read for them, too
  bool told_no_transform_ = false;  ///< and it was not there since
  bool told_hopeless_ = false;
  bool told_not_from_origin_ = false;
  bool told_assumed_origin_ = false;
  bool told_found_camera_ = false;
  std::string silence_;  ///< why no cloud comes, as it was told; empty: clouds come
  bool told_incomplete_ = false;
  Throttle input_warning_{5.0}, silence_check_{5.0}, transform_warning_{5.0}, failure_warning_{5.0}, jump_warning_{10.0};

  std::unique_ptr<TransformInbox> transforms_;  ///< where a frame is named
  std::unique_ptr<dynamic_reconfigure::Server<DetectorConfig>> reconfigure_;
  ros::Publisher primitives_, markers_, labels_, normals_;
  ros::Subscriber input_;
  ros::WallTimer diagnostics_timer_, transform_timer_;
};

}  // namespace primitect::ros_layer
