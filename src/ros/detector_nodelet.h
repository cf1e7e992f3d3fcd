// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The nodelet primitect/detector: topics, parameters and time around a FramePipeline.
#pragma once

#include <dynamic_reconfigure/server.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <string>

#include "detector_diagnostics.h"
#include "frame_pipeline.h"
#include "late_transform.h"
#include "markers.h"
#include "parameters.h"
#include "tracking.h"

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
  /// Primitives in sensor_frame, or none and why that is not possible.
  PrimitiveArray& detect(const sensor_msgs::PointCloud2& cloud);
  void publish(const PrimitiveArray& message);
  /// Once, or once more after parameters changed.
  void warnIfHopeless();
  /// Once, or once more after parameters changed.
  void warnIfNotSeenFromOrigin();
  /// Once, or once more after parameters changed.
  void tellFoundCamera();
  /// Once for each silence: a wrong topic is the most common mistake, and not everybody looks at diagnostics.
  void warnIfSilent();
  void startAnewIfTimeWentBack(const ros::Time& stamp);
  /// Moves the primitives from the sensor's frame to target_frame or that of the cloud; empty, or why that is not
  /// possible. A message without search stays in the cloud's frame: whether another can be reached was not asked.
  std::string toTargetFrame(const std::string& cloud_frame, PrimitiveArray& message);
  void track(PrimitiveArray& message);

  /// Callbacks are serial, but onInit() runs in another thread than they do.
  boost::recursive_mutex mutex_;
  bool started_ = false;

  std::unique_ptr<FramePipeline> pipeline_;
  std::unique_ptr<DetectorDiagnostics> diagnostics_;
  PrimitiveTracker tracker_;
  MarkerWriter marker_writer_;
  MarkerStyle marker_style_;
  ros::Time last_stamp_;
  std_msgs::Header sensor_header_;  ///< of the last cloud, in the frame where it was searched
  bool with_labels_ = false;        ///< the last cloud was read for them, too
  bool told_hopeless_ = false;
  bool told_not_from_origin_ = false;
  bool told_found_camera_ = false;
  bool told_silent_ = false;
  Throttle input_warning_{5.0}, transform_warning_{5.0}, failure_warning_{5.0};

  std::unique_ptr<tf2_ros::Buffer> transforms_;
  std::unique_ptr<tf2_ros::TransformListener> transform_listener_;
  std::unique_ptr<LateTransforms> late_transforms_;
  std::unique_ptr<dynamic_reconfigure::Server<DetectorConfig>> reconfigure_;
  ros::Publisher primitives_, markers_, labels_, normals_;
  ros::Subscriber input_;
  ros::WallTimer diagnostics_timer_;
};

}  // namespace primitect::ros_layer
